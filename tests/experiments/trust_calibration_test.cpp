// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/trust_calibration.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/pair_rendering.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;
using tracker::TrackingStatus;

TEST(TrustCalibration, PairsAreSpreadOverThePath) {
  const std::vector<TrustPair> pairs = TrustPairs(4, 10, 0);
  ASSERT_EQ(pairs.size(), 20u);
  int jumps = 0;
  for (const TrustPair& pair : pairs) {
    EXPECT_GE(pair.reference_s, 0);
    EXPECT_GE(pair.current_s, 0);
    EXPECT_LE(std::max(pair.reference_s, pair.current_s), 4);
    jumps += pair.jump ? 1 : 0;
    if (pair.jump) continue;
    EXPECT_GT(pair.current_s, pair.reference_s);
    EXPECT_LE(pair.current_s, pair.reference_s + 0.5);
  }
  EXPECT_EQ(jumps, 10);
  EXPECT_LT(pairs.front().reference_s, 0.4);
  EXPECT_GT(pairs.back().reference_s, 3);
  EXPECT_NE(TrustPairs(4, 10, 1)[0].current_s, pairs[0].current_s);
  EXPECT_THROW(TrustPairs(0.9, 10, 0), Error);
}

TEST(TrustCalibration, TheBandIsThatOfChiSquare) {
  // Quantiles 0.005 and 0.995 of χ² with 6 and with 600 degrees of freedom.
  EXPECT_NEAR(MeanChiSquare6Band(1).low, 0.676, 0.07);
  EXPECT_NEAR(MeanChiSquare6Band(1).high, 18.55, 0.1);
  EXPECT_NEAR(MeanChiSquare6Band(100).low, 5.146, 0.01);
  EXPECT_NEAR(MeanChiSquare6Band(100).high, 6.932, 0.01);
}

TrustSample Sample(TrackingStatus status, double square, double distance_m = 0, bool jump = false) {
  TrustSample sample;
  sample.images = "sharp";
  sample.preset = "fast";
  sample.status = status;
  sample.square = square;
  sample.error = {distance_m, 0};
  sample.pair.jump = jump;
  return sample;
}

TEST(TrustCalibration, SummariesCountAndTakeMeansOfTrackedFrames) {
  const auto tracked = TrackingStatus::kTracked, doubtful = TrackingStatus::kDoubtful,
             lost = TrackingStatus::kLost;
  TrustSample other = Sample(tracked, 3);
  other.preset = "paper";
  const auto summaries = SummarizeTrust(
      {Sample(tracked, 10), Sample(doubtful, 1e6), other, Sample(lost, 0, 9), Sample(tracked, 20),
       Sample(tracked, 90), Sample(tracked, 1e9, 0.2, true), Sample(doubtful, 1, 0.2, true),
       Sample(lost, 0, 0.2, true), Sample(tracked, 1, 0.01, true)});
  ASSERT_EQ(summaries.size(), 2u);
  const TrustSummary& s = summaries[0];
  EXPECT_EQ(s.preset, "fast");
  EXPECT_EQ(s.tracked, 3);
  EXPECT_EQ(s.doubtful, 1);
  EXPECT_EQ(s.lost, 1);
  EXPECT_EQ(s.mean_square, 40);
  EXPECT_NEAR(s.factor(), 40.0 / 6, 1e-12);
  EXPECT_EQ(s.median_square, 20);
  EXPECT_FALSE(s.calibrated());
  EXPECT_EQ(s.jumps_tracked, 2);
  EXPECT_EQ(s.jumps_doubtful, 1);
  EXPECT_EQ(s.jumps_lost, 1);
  EXPECT_EQ(s.wild_tracked, 1);
  EXPECT_EQ(s.wild_doubtful, 1);
  EXPECT_TRUE(summaries[1].calibrated());
  EXPECT_THAT(FormatTrust(summaries),
              HasSubstr("sharp    fast                    3        1    1"));
}

TEST(TrustCalibration, ASampleTellsTheErrorOfAPoseAndItsCovariance) {
  const World& world = StudioWorld();
  const FramePair pair = RenderPair(world, SmallPictures(), 1, 1.2);
  const TrustSample sample = MeasureTrust(pair, {"accurate", "cpu", "sparse", 0});
  EXPECT_EQ(sample.status, TrackingStatus::kTracked) << sample.message;
  EXPECT_GT(sample.error.distance_m, 0);
  EXPECT_LT(sample.error.distance_m, 2e-3);
  ASSERT_TRUE(sample.square.has_value());
  EXPECT_GT(*sample.square, 0);
  EXPECT_LT(*sample.square, 200);
  EXPECT_FALSE(sample.wild());
  EXPECT_EQ(sample.ToJson()["status"], "tracked");
  EXPECT_GT(sample.evidence.inlier_ratio, 0.9);
}

// Ten pairs under Handa's noise, each with its own: NEES is 6 within a factor that so few pairs and
// another scene than the one of the measured factor allow, and that a covariance ten times too
// large or too small does not.
TEST(TrustCalibration, CovariancesOfNoisyPairsAreOfTheRightSize) {
  const World& world = StudioWorld();
  for (const char* preset : {"accurate", "fast"}) {
    std::vector<TrustSample> samples;
    for (const TrustPair& pair : TrustPairs(world.path.duration_s(), 10, 3)) {
      if (pair.jump) continue;
      sim::RenderOptions rendering = SmallPictures();
      rendering.sensor = PaperRenderOptions(true).sensor;
      rendering.seed = samples.size();
      samples.push_back(MeasureTrust(RenderPair(world, rendering, pair.reference_s, pair.current_s),
                                     {preset, "cpu", "sparse", 0}));
      samples.back().pair = pair;
    }
    const TrustSummary summary = SummarizeTrust(samples).front();
    EXPECT_GE(summary.tracked, 9) << preset;
    EXPECT_GT(summary.mean_square, 6 / 5.0) << preset;
    EXPECT_LT(summary.mean_square, 6 * 5.0) << preset;
  }
}

}  // namespace
}  // namespace silt::experiments
