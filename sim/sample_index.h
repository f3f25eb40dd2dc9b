// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "silt/sim/huge_pages.h"

namespace silt::sim {

// Numbers samples by where they are: the same key gets the same number, a new one the next. A hash
// table with open addressing, since it is filled with millions while a user waits.
class SampleIndex {
 public:
  // Position and normal, rounded.
  using Key = std::array<std::int32_t, 6>;

  explicit SampleIndex(std::size_t expected);

  // The number of a key. It is new if it equals the size() before.
  std::uint32_t NumberOf(const Key& key);
  // The next number, for a sample that no other equals: quicker, and no key has it.
  std::uint32_t NewNumber();
  std::size_t size() const { return keys_.size(); }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;
  // Part of the key's hash, for which most other keys need not be looked at.
  struct Slot {
    std::uint32_t number = kFree, tag = 0;
  };

  Slot& SlotOf(const Key& key);
  void Rehash(std::size_t slots);

  HugePageVector<Key> keys_;    // by number
  HugePageVector<Slot> slots_;  // a power of two, at least twice as many as keys
};

}  // namespace silt::sim
