// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sample_index.h"

#include <algorithm>
#include <bit>

namespace silt::sim {

namespace {

std::size_t Hash(const SampleIndex::Key& key) {
  std::uint64_t hash = 0;
  for (const std::int32_t k : key) {
    hash = (hash ^ std::uint32_t(k)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return std::size_t(hash);
}

}  // namespace

SampleIndex::SampleIndex(std::size_t expected) {
  keys_.reserve(expected);
  Rehash(std::bit_ceil(2 * expected + 2));
}

// Where the key is, or where it belongs.
std::size_t SampleIndex::SlotOf(const Key& key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = Hash(key) & mask;
  while (slots_[slot] != kFree && keys_[slots_[slot]] != key) slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t SampleIndex::NumberOf(const Key& key) {
  std::uint32_t& number = slots_[SlotOf(key)];
  if (number != kFree) return number;
  number = std::uint32_t(keys_.size());
  keys_.push_back(key);
  if (2 * keys_.size() > slots_.size()) Rehash(2 * slots_.size());
  return std::uint32_t(keys_.size() - 1);
}

void SampleIndex::Rehash(std::size_t slots) {
  slots_.assign(slots, kFree);
  for (std::size_t i = 0; i < keys_.size(); ++i) slots_[SlotOf(keys_[i])] = std::uint32_t(i);
}

}  // namespace silt::sim
