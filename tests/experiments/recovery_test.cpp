// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/recovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/experiments/pair_rendering.h"
#include "silt/tracker/cpu_backend.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

TEST(RandomStarts, UpToABoundFillItEvenly) {
  const RandomStarts starts{{0.1, 5}, 1, 3, true};
  constexpr int kDraws = 2000;
  double sum_m = 0, sum_deg = 0, product = 0;
  for (int i = 0; i < kDraws; ++i) {
    const PoseDifference offset = starts.OffsetOf(i);
    EXPECT_TRUE(offset.Within({0.1, 5}));
    sum_m += offset.distance_m / 0.1;
    sum_deg += offset.angle_deg / 5;
    product += (offset.distance_m / 0.1 - 0.5) * (offset.angle_deg / 5 - 0.5);
  }
  // Means of variance 1/(12 n), 4σ; independent of one another: a covariance of variance 1/(144 n).
  const double bound = 4 / std::sqrt(12.0 * kDraws);
  EXPECT_NEAR(sum_m / kDraws, 0.5, bound);
  EXPECT_NEAR(sum_deg / kDraws, 0.5, bound);
  EXPECT_NEAR(product / kDraws, 0, 4 / std::sqrt(144.0 * kDraws));
  EXPECT_EQ((RandomStarts{{0.1, 5}, 1, 3, false}.OffsetOf(7).angle_deg), 5);
}

TEST(RecoverySet, IsNamedByItsBound) {
  EXPECT_EQ(kRecoverySets[0].Name(), "up to 10 cm and 5 deg");
  EXPECT_EQ(kRecoverySets[3].Name(), "at 20 cm and 10 deg");
}

TEST(Recovery, IsMeasuredForEveryPresetSchemeAndSet) {
  const auto backend = tracker::MakeCpuBackend();
  const std::vector<FramePair> pairs = {RenderPair(StudioWorld(), SmallPictures(160), 1, 1.1),
                                        RenderPair(StudioWorld(), SmallPictures(160), 2, 2.1)};
  RecoveryOptions options;
  options.presets = {"fast"};
  options.starts = 4;
  options.comparison = 2;
  const std::vector<Recovery> all = MeasureRecovery(pairs, *backend, options);
  ASSERT_EQ(all.size(), 12u);
  EXPECT_EQ(all[0].scheme, kWideScheme);
  EXPECT_EQ(all[0].success.starts, 4);
  EXPECT_EQ(all[4].scheme, kPyramidScheme);
  EXPECT_EQ(all[11].scheme, kSingleLevelScheme);
  EXPECT_EQ(all[11].success.starts, 2);
  options.presets = {"paper"};
  options.comparison = 0;
  const std::vector<Recovery> paper = MeasureRecovery(pairs, *backend, options);
  ASSERT_EQ(paper.size(), 4u);
  EXPECT_EQ(paper[0].scheme, kPyramidScheme);
  EXPECT_EQ(paper[0].success.starts, 4);
  const Json rows = RecoveryRows(all);
  EXPECT_EQ(rows[0].at("set"), "up to 10 cm and 5 deg");
  EXPECT_EQ(rows[0].at("rate"), all[0].success.rate());
  EXPECT_EQ(rows[4].at("scheme"), "pyramid");
  EXPECT_THAT(FormatRecovery(all, pairs), testing::HasSubstr("single level"));
}

// From 20 cm and 10° beside the truth, one level is lost.
TEST(Recovery, IsForAWideStartWhatItIsNotForOneLevel) {
  const auto backend = tracker::MakeCpuBackend();
  const std::vector<FramePair> pairs = {RenderPair(StudioWorld(), SmallPictures(320), 1, 1.1)};
  RecoveryOptions options;
  options.presets = {"accurate"};
  options.starts = options.comparison = 4;
  const std::vector<Recovery> all = MeasureRecovery(pairs, *backend, options);
  EXPECT_GE(all[3].success.recovered, 3);
  EXPECT_EQ(all[11].success.recovered, 0);
}

TEST(Recovery, TellsWhatThePairsShow) {
  const FramePair pair = RenderPair(StudioWorld(), SmallPictures(64), 1, 1.5);
  const Json rows = PairRows({pair});
  ASSERT_EQ(rows.size(), 1u);
  const double low = rows[0].at("min_depth_m"), mid = rows[0].at("median_depth_m");
  EXPECT_LT(low, mid);
  EXPECT_LT(mid, rows[0].at("max_depth_m").get<double>());
  EXPECT_NEAR(rows[0].at("motion_m").get<double>(),
              Difference(pair.current_from_reference, SE3d{}).distance_m, 1e-12);
}

}  // namespace
}  // namespace silt::experiments
