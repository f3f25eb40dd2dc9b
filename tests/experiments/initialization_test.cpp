// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initialization.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/color.h"
#include "silt/experiments/initialization_report.h"
#include "silt/tracker/cpu_backend.h"
#include "studio_world.h"

namespace silt::experiments {

static void PrintTo(StartMethod method, std::ostream* out) { *out << Name(method); }

namespace {

tracker::Keyframe KeyframeAt(double time_s, const sim::RenderOptions& rendering) {
  tracker::Keyframe keyframe;
  keyframe.frame = RenderAt(StudioWorld(), rendering, time_s);
  keyframe.intensity = GrayFromRgb(keyframe.frame.rgb);
  return keyframe;
}

// From 1 s to `current`, which was taken at 1.25 s.
std::vector<StartOutcome> OutcomesOf(const Frame& current, const tracker::Keyframe& keyframe,
                                     const PinholeCamera& camera) {
  const auto pose = [](double time_s) { return StudioWorld().path.WorldFromCamera(time_s); };
  const InitializationCase each{keyframe,
                                current,
                                camera,
                                pose(1.25).Inverse() * pose(1),
                                pose(1.2).Inverse() * pose(1),
                                pose(1.15).Inverse() * pose(1),
                                5,
                                0};
  const auto backend = tracker::MakeCpuBackend();
  return TryStarts(each, *backend, MakeInitializers(), tracker::PaperPreset().alignment);
}

TEST(Initialization, TriesEveryStart) {
  const sim::RenderOptions rendering = SmallPictures(640);
  const tracker::Keyframe keyframe = KeyframeAt(1, rendering);
  const auto outcomes =
      OutcomesOf(RenderAt(StudioWorld(), rendering, 1.25), keyframe, rendering.camera);
  ASSERT_EQ(outcomes.size(), 9u);
  for (const StartOutcome& outcome : outcomes) EXPECT_TRUE(outcome.available);
  const auto of = [&](StartMethod method) { return outcomes[std::size_t(method)]; };
  const double identity_m = of(StartMethod::kIdentity).start.distance_m;
  const double previous_m = of(StartMethod::kPrevious).start.distance_m;
  EXPECT_GT(identity_m, previous_m);
  EXPECT_GT(previous_m, of(StartMethod::kConstantVelocity).start.distance_m);
  EXPECT_TRUE(of(StartMethod::kPrevious).success);
  EXPECT_EQ(of(StartMethod::kIdentity).milliseconds, 0);
  const StartOutcome rotation = of(StartMethod::kRotation), truth = of(StartMethod::kTruth);
  // From where the previous frame was; a turn alone makes up for some of the way, too.
  EXPECT_NE(rotation.start.angle_deg, of(StartMethod::kPrevious).start.angle_deg);
  EXPECT_LT(rotation.start.angle_deg, 0.5 * of(StartMethod::kIdentity).start.angle_deg);
  EXPECT_TRUE(rotation.success);
  EXPECT_GT(rotation.milliseconds, 0);
  EXPECT_NEAR(truth.start.distance_m, 0.02, 1e-9);
  EXPECT_NEAR(truth.start.angle_deg, 1, 1e-6);
}

class FeatureStart : public testing::TestWithParam<StartMethod> {};

TEST_P(FeatureStart, LiesBesideTheTruth) {
  const sim::RenderOptions rendering = SmallPictures(640);
  static const tracker::Keyframe keyframe = KeyframeAt(1, rendering);
  static const auto outcomes =
      OutcomesOf(RenderAt(StudioWorld(), rendering, 1.25), keyframe, rendering.camera);
  const StartOutcome& outcome = outcomes[std::size_t(GetParam())];
  EXPECT_LT(outcome.start.distance_m, 0.01);
  EXPECT_LT(outcome.start.angle_deg, 0.5);
  EXPECT_TRUE(outcome.success);
  EXPECT_GT(outcome.inliers, 20);
  EXPECT_GE(outcome.matches, outcome.inliers);
  EXPECT_GT(outcome.milliseconds, 0);
}

INSTANTIATE_TEST_SUITE_P(Initialization, FeatureStart,
                         testing::Values(StartMethod::kSurf, StartMethod::kSift, StartMethod::kOrb,
                                         StartMethod::kAkaze));

TEST(Initialization, KnowsEveryMethodByTheNameOfTheCommandLine) {
  for (const StartMethod method : kStartMethods) {
    EXPECT_NO_THROW(ParseInitializer(Name(method))) << Name(method);
  }
}

TEST(Initialization, SaysWhereAStartIsNotAvailable) {
  const sim::RenderOptions rendering = SmallPictures();
  const tracker::Keyframe keyframe = KeyframeAt(1, rendering);
  Frame blank;
  blank.rgb = Image<Rgb8>(rendering.camera.width, rendering.camera.height, Rgb8{90, 90, 90});
  const auto outcomes = OutcomesOf(blank, keyframe, rendering.camera);
  for (const StartOutcome& outcome : outcomes) {
    const bool looks =
        outcome.method >= StartMethod::kSurf && outcome.method <= StartMethod::kAkaze;
    if (looks) {
      EXPECT_FALSE(outcome.available) << Name(outcome.method);
    }
    EXPECT_FALSE(outcome.success);
  }
  EXPECT_TRUE(outcomes[0].available && outcomes[1].available);
}

StartOutcome Sparse(bool available, double start_m, bool success, int inliers) {
  StartOutcome outcome;
  outcome.method = StartMethod::kSurf;
  outcome.available = available;
  outcome.start.distance_m = start_m;
  outcome.success = success;
  outcome.inliers = inliers;
  return outcome;
}

TEST(Initialization, SummarizesErrorsWhereThereIsAPoseAndSuccessOverAll) {
  const std::vector<StartOutcome> outcomes = {
      Sparse(true, 0.01, true, 100), Sparse(true, 0.03, false, 20), Sparse(false, 0, false, 0), {}};
  const StartSummary summary = Summarize(StartMethod::kSurf, outcomes);
  EXPECT_EQ(summary.cases, 3);
  EXPECT_EQ(summary.available, 2);
  EXPECT_EQ(summary.successes, 1);
  EXPECT_DOUBLE_EQ(summary.start.distance_m, 0.02);
  EXPECT_DOUBLE_EQ(summary.inliers, 20);
}

TEST(Initialization, ReportsGroupsInTheOrderOfTheirFirstCase) {
  const std::vector<StartOutcome> one = {Sparse(true, 0.01, true, 100)};
  const std::vector<StartOutcome> none = {Sparse(false, 0, false, 0)};
  const std::vector<InitializationRecord> records = {
      {"sharp", 1, 0, one}, {"sharp", 40, 0, none}, {"sharp", 1, 5, one}, {"blurred", 1, 0, one}};
  const Json rows = SummaryRows(records);
  ASSERT_EQ(rows.size(), 27u);  // three groups of nine methods
  EXPECT_EQ(rows[4].at("method"), "surf");
  EXPECT_EQ(rows[4].at("cases"), 2);
  EXPECT_EQ(rows[4].at("rate"), 1);
  EXPECT_EQ(rows[13].at("gap"), 40);
  EXPECT_EQ(rows[13].at("successes"), 0);
  EXPECT_EQ(rows[22].at("condition"), "blurred");
  const Json cases = CaseRows(records);
  EXPECT_EQ(cases.size(), 4u);
  EXPECT_TRUE(cases[1].at("start_distance_m").is_null());
}

}  // namespace
}  // namespace silt::experiments
