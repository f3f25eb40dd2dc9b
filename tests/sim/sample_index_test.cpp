// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sample_index.h"

#include <gtest/gtest.h>

namespace silt::sim {
namespace {

SampleIndex::Key KeyOf(int i) { return {i, i * i % 1009, -i, 0, i % 3, 1}; }

TEST(SampleIndex, NumbersKeysInTheOrderOfTheirFirstUse) {
  for (const std::size_t expected : {std::size_t{0}, std::size_t{5000}}) {
    SampleIndex index(expected);
    for (std::uint32_t i = 0; i < 3000; ++i) EXPECT_EQ(index.NumberOf(KeyOf(int(i))), i);
    for (std::uint32_t i = 0; i < 3000; ++i) EXPECT_EQ(index.NumberOf(KeyOf(int(i))), i);
    EXPECT_EQ(index.size(), 3000u);
  }
}

TEST(SampleIndex, KeysThatDifferInOneNumberAreTwo) {
  SampleIndex index(0);
  EXPECT_EQ(index.NumberOf({1, 2, 3, 4, 5, 6}), 0u);
  for (std::size_t i = 0; i < 6; ++i) {
    SampleIndex::Key key{1, 2, 3, 4, 5, 6};
    key[i] = 7;
    EXPECT_EQ(index.NumberOf(key), i + 1);
  }
}

TEST(SampleIndex, NewNumbersAreNoKeys) {
  SampleIndex index(0);
  EXPECT_EQ(index.NumberOf({1, 2, 3, 4, 5, 6}), 0u);
  for (std::uint32_t i = 1; i < 100; ++i) EXPECT_EQ(index.NewNumber(), i);
  for (std::uint32_t i = 100; i < 1000; ++i) EXPECT_EQ(index.NumberOf(KeyOf(int(i))), i);
  for (std::uint32_t i = 100; i < 1000; ++i) EXPECT_EQ(index.NumberOf(KeyOf(int(i))), i);
  EXPECT_EQ(index.NumberOf({1, 2, 3, 4, 5, 6}), 0u);
  EXPECT_EQ(index.size(), 1000u);
}

}  // namespace
}  // namespace silt::sim
