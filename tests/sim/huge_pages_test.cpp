// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/huge_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

namespace silt::sim {
namespace {

TEST(HugePages, HoldWhatIsWrittenAndAreAligned) {
  for (const std::size_t n : {std::size_t{1}, std::size_t{1000}, std::size_t{3} << 20}) {
    HugePageVector<std::uint32_t> values(n);
    std::iota(values.begin(), values.end(), 0u);
    EXPECT_EQ(values.back(), n - 1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(values.data()) % 64, 0u);
    values.resize(2 * n);  // moves
    EXPECT_EQ(values[n - 1], n - 1);
  }
}

TEST(HugePages, LargeArraysStartAtAHugePage) {
  const HugePageVector<char> values(std::size_t{5} << 20);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(values.data()) % (std::size_t{2} << 20), 0u);
}

}  // namespace
}  // namespace silt::sim
