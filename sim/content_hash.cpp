// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/content_hash.h"

#include <algorithm>
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
  for (std::size_t i = 0; i < size; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
    state_[0] = Mix(state_[0] ^ word, 0x9e3779b97f4a7c15u);
    state_[1] = Mix(state_[1] + word, 0xc2b2ae3d27d4eb4fu);
  }
  state_[0] = Mix(state_[0] ^ size, 0x9e3779b97f4a7c15u);
  state_[1] = Mix(state_[1] + size, 0xc2b2ae3d27d4eb4fu);
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
