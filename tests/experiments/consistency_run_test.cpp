// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/consistency_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt_program.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

constexpr ConsistencyPlan kPlan{320, 2, 10, 60};

ConsistencyResult Measured(int samples, bool eight_bits,
                           sim::PixelPattern pattern = sim::PixelPattern::kShared,
                           sim::PixelFilter filter = sim::PixelFilter::kBox) {
  return MeasureConsistency(StudioWorld(), kPlan, {"", samples, pattern, filter, eight_bits});
}

TEST(ConsistencyRun, FramesAgreeWithTheTruthAboutThem) {
  const ConsistencyResult coarse = Measured(4, true), fine = Measured(64, false);
  EXPECT_GT(coarse.pixels_gradient, 1000u);
  // A quarter above what was measured; with cones of half a pixel both were twice as much.
  EXPECT_LT(coarse.median_gradient, 0.34);
  EXPECT_LT(fine.median_gradient, 0.22);
  EXPECT_LT(fine.median_gradient, coarse.median_gradient);
}

// What the simulator promises of many samples under the Gaussian filter.
TEST(ConsistencyRun, AntiAliasedFramesAgreeWithinTheQuantisation) {
  const auto gaussian = [](bool eight_bits) {
    return Measured(64, eight_bits, sim::PixelPattern::kShared, sim::PixelFilter::kGaussian)
        .median_gradient;
  };
  EXPECT_LT(gaussian(false), 0.08);
  EXPECT_LT(gaussian(true), 0.25);
}

TEST(ConsistencyRun, ASharedPatternMakesNoNoise) {
  EXPECT_LT(Measured(4, false).median_gradient,
            Measured(4, false, sim::PixelPattern::kScrambled).median_gradient);
}

TEST(ConsistencyRun, DepthsPosesAndIntrinsicsAgree) {
  const DepthConsistency depth = MeasureDepthConsistency(StudioWorld(), kPlan);
  EXPECT_LT(depth.median_m, 1e-6);
  EXPECT_LT(depth.maximum_m, 1e-5);
  EXPECT_EQ(depth.beyond, 0u);
  EXPECT_GT(depth.pixels, 100'000u);
  EXPECT_LT(depth.hidden, depth.pixels / 4);
}

TEST(ConsistencyRun, APathShorterThanAPairIsRefused) {
  EXPECT_THROW(MeasureDepthConsistency(StudioWorld(), {64, 1, 1000, 1}), Error);
}

TEST(ConsistencyRun, TheCommandTellsEachCase) {
  const ProgramResult result = RunSilt(
      "experiment photo-consistency --scene studio --width 64 --pairs 1 --apart 2 --json -");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["pictures"].size(), ConsistencyCases().size());
  EXPECT_GT(json["pictures"][0]["pixels"], 100);
  EXPECT_LT(json["depth"]["maximum_m"], 1e-5);
  EXPECT_EQ(json["depth"]["beyond_1e-5_m"], 0);
}

}  // namespace
}  // namespace silt::experiments
