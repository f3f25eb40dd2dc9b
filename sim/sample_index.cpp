// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sample_index.h"

#include <algorithm>
#include <bit>

namespace silt::sim {

namespace {

// Of numbers without a key: no normal is so long.
constexpr SampleIndex::Key kNoKey{0, 0, 0, 1 << 30, 1 << 30, 1 << 30};

std::uint64_t Hash(const SampleIndex::Key& key) {
  std::uint64_t hash = 0;
  for (const std::int32_t k : key) {
    hash = (hash ^ std::uint32_t(k)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

// A loop that is no call, unlike std::array's own.
bool AreSame(const SampleIndex::Key& a, const SampleIndex::Key& b) {
  std::int32_t difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
  return difference == 0;
}

}  // namespace

SampleIndex::SampleIndex(std::size_t expected) {
  keys_.reserve(expected);
  Rehash(std::bit_ceil(2 * expected + 2));
}

// Where the key is, or where it belongs: then it is left there with its tag.
SampleIndex::Slot& SampleIndex::SlotOf(const Key& key) {
  const std::uint64_t hash = Hash(key);
  const auto tag = std::uint32_t(hash >> 32);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = std::size_t(hash) & mask;; i = (i + 1) & mask) {
    Slot& slot = slots_[i];
    if (slot.number == kFree) slot.tag = tag;
    if (slot.number == kFree || (slot.tag == tag && AreSame(keys_[slot.number], key))) return slot;
  }
}

std::uint32_t SampleIndex::NumberOf(const Key& key) {
  std::uint32_t& number = SlotOf(key).number;
  if (number != kFree) return number;
  number = std::uint32_t(keys_.size());
  keys_.push_back(key);
  if (2 * keys_.size() > slots_.size()) Rehash(2 * slots_.size());
  return std::uint32_t(keys_.size() - 1);
}

std::uint32_t SampleIndex::NewNumber() {
  keys_.push_back(kNoKey);
  return std::uint32_t(keys_.size() - 1);
}

void SampleIndex::Rehash(std::size_t slots) {
  slots_.assign(slots, Slot{});
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    SlotOf(keys_[i]).number = std::uint32_t(i);
  }
}

}  // namespace silt::sim
