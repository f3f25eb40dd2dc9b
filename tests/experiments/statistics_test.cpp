// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "silt/core/random.h"

namespace silt::experiments {
namespace {

TEST(Statistics, AreThoseOfAListDoneByHand) {
  // Sum 5, squares 55: mean 1, mean square 11, variance 11 − 1.
  const Statistics s = Summarize({4, 1, -5, 3, 2});
  EXPECT_EQ(s.count, 5);
  EXPECT_DOUBLE_EQ(s.mean, 1);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(11.0));
  EXPECT_DOUBLE_EQ(s.std_dev, std::sqrt(10.0));
  EXPECT_DOUBLE_EQ(s.median, 2);
  EXPECT_DOUBLE_EQ(s.min, -5);
  EXPECT_DOUBLE_EQ(s.max, 4);
}

TEST(Statistics, OfOneValue) {
  const Statistics s = Summarize({-3});
  EXPECT_DOUBLE_EQ(s.rmse, 3);
  EXPECT_DOUBLE_EQ(s.median, -3);
  EXPECT_DOUBLE_EQ(s.std_dev, 0);
}

TEST(Statistics, TheMedianOfAnEvenNumberIsTheMeanOfTheMiddleTwo) {
  EXPECT_DOUBLE_EQ(Median({10, 1, 4, 2}), 3);
}

TEST(Statistics, ASmallSpreadAboutALargeMeanDoesNotCancel) {
  EXPECT_NEAR(Summarize({1e9, 1e9 + 1, 1e9 + 2}).std_dev, std::sqrt(2.0 / 3), 1e-6);
}

TEST(Statistics, OfNothingBreaksTheContract) { EXPECT_THROW(Summarize({}), std::logic_error); }

// The median of 101 values with a standard deviation of 1 is known to 1.25/sqrt(101).
TEST(MedianDifference, IsAsWideAsMediansScatter) {
  const CounterRandom random(4);
  std::vector<double> a, b;
  for (std::uint64_t i = 0; i < 101; ++i) {
    a.push_back(5 + random.Normal(2 * i));
    b.push_back(random.Normal(2 * i + 1));
  }
  const Interval interval = MedianDifference(a, b);
  EXPECT_NEAR(interval.high - interval.low, 2 * 1.96 * std::sqrt(2.0) * 1.2533 / std::sqrt(101),
              0.25);
  EXPECT_NEAR((interval.low + interval.high) / 2, 5, 0.4);
}

}  // namespace
}  // namespace silt::experiments
