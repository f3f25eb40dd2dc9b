// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/success_rate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace silt::experiments {
namespace {

const SE3d kTruth = SE3d::Exp({{0.1, -0.2, 0.15}, {0.12, -0.05, 0.08}});

TEST(RandomStart, IsAsFarAwayAsAsked) {
  for (int i = 0; i < 20; ++i) {
    const PoseDifference found = Difference(kTruth, RandomStart(kTruth, {0.07, 12}, 5, i));
    EXPECT_NEAR(found.distance_m, 0.07, 1e-12);
    EXPECT_NEAR(found.angle_deg, 12, 1e-9);
  }
}

TEST(RandomStart, IsAFunctionOfSeedAndIndex) {
  const auto apart = [](std::uint64_t seed, int index) {
    return Difference(RandomStart(kTruth, {0.1, 5}, 1, 0),
                      RandomStart(kTruth, {0.1, 5}, seed, index))
        .distance_m;
  };
  EXPECT_EQ(apart(1, 0), 0);
  EXPECT_GT(apart(1, 1), 1e-3);
  EXPECT_GT(apart(2, 0), 1e-3);
}

// The mean of n directions, uniform on the sphere, has components of variance 1/(3n): below 4σ for
// all three but for one seed in 5000.
TEST(RandomStart, HasNoPreferredDirection) {
  constexpr int kStarts = 2000;
  Vec3d sum;
  for (int i = 0; i < kStarts; ++i) {
    sum += RandomStart(kTruth, {1, 0}, 9, i).Inverse().translation - kTruth.Inverse().translation;
  }
  const double bound = 4 * std::sqrt(kStarts / 3.0);
  EXPECT_LT(std::abs(sum.x), bound);
  EXPECT_LT(std::abs(sum.y), bound);
  EXPECT_LT(std::abs(sum.z), bound);
}

// All of them, and never too many at once to be interrupted between.
TEST(MeasureSuccessRate, TakesManyStartsInShares) {
  std::size_t most = 0, all = 0;
  const AlignAllFrom align = [&](std::size_t, const std::vector<SE3d>& poses) {
    most = std::max(most, poses.size());
    std::vector<tracker::AlignmentResult> results(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const SE3d start = RandomStart(kTruth, {0.1, 5}, 3, int(all++));
      EXPECT_EQ(poses[i].translation.x, start.translation.x);
    }
    return results;
  };
  const SuccessRate rate = MeasureSuccessRate({kTruth}, {{0.1, 5}, 5000, 3}, align);
  EXPECT_EQ(rate.starts, 5000);
  EXPECT_EQ(all, 5000u);
  EXPECT_EQ(most, std::size_t(kStartsAtOnce));
}

// Reference values: Wilson's interval for 8 of 10 and for none of 20, as statsmodels has them.
TEST(WilsonInterval, MatchesReferenceValues) {
  const Interval some = WilsonInterval(8, 10), none = WilsonInterval(0, 20);
  EXPECT_NEAR(some.low, 0.49016, 1e-5);
  EXPECT_NEAR(some.high, 0.94332, 1e-5);
  EXPECT_NEAR(none.low, 0, 1e-12);
  EXPECT_NEAR(none.high, 0.16113, 1e-5);
  EXPECT_EQ(WilsonInterval(0, 0).high, 1);
}

}  // namespace
}  // namespace silt::experiments
