// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/content_hash.h"

#include <cstdio>

namespace silt::sim {

namespace {

std::uint64_t Mix(std::uint64_t z, std::uint64_t multiplier) {
  z *= multiplier;
  return z ^ (z >> 32);
}

}  // namespace

ContentHash& ContentHash::AddBytes(const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  const std::size_t rest = size % 8;
  // Hundreds of megabytes come by: the state stays in registers, and words are copied as words.
  std::uint64_t a = state_[0], b = state_[1], word = 0;
  const auto add = [&](std::uint64_t value) {
    a = Mix(a ^ value, 0x9e3779b97f4a7c15u);
    b = Mix(b + value, 0xc2b2ae3d27d4eb4fu);
  };
  for (std::size_t i = 0; i < size - rest; i += 8) {
    std::memcpy(&word, bytes + i, 8);
    add(word);
  }
  if (rest > 0) {
    word = 0;
    std::memcpy(&word, bytes + (size - rest), rest);
    add(word);
  }
  add(size);
  state_[0] = a;
  state_[1] = b;
  return *this;
}

std::string ContentHash::Digest() const {
  char text[33];
  std::snprintf(text, sizeof(text), "%016llx%016llx",
                static_cast<unsigned long long>(Mix(state_[0], 0xbf58476d1ce4e5b9u)),
                static_cast<unsigned long long>(Mix(state_[1], 0x94d049bb133111ebu)));
  return text;
}

}  // namespace silt::sim
