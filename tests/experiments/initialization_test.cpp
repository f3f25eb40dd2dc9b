// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initialization.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/color.h"
#include "silt/experiments/initialization_report.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/sparse/sparse_initializer.h"
#include "studio_world.h"

namespace silt::experiments {
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
  const InitializationCase each{
      keyframe, current, camera, pose(1.25).Inverse() * pose(1), pose(1.2).Inverse() * pose(1),
      5,        0};
  const auto backend = tracker::MakeCpuBackend();
  tracker::SparseInitializer initializer;
  return TryStarts(each, *backend, initializer, tracker::PaperPreset().alignment);
}

TEST(Initialization, TriesEveryStart) {
  const sim::RenderOptions rendering = SmallPictures(640);
  const tracker::Keyframe keyframe = KeyframeAt(1, rendering);
  const auto outcomes =
      OutcomesOf(RenderAt(StudioWorld(), rendering, 1.25), keyframe, rendering.camera);
  ASSERT_EQ(outcomes.size(), 3u);
  const StartOutcome &identity = outcomes[0], &previous = outcomes[1], &sparse = outcomes[2];
  EXPECT_TRUE(identity.available && previous.available && sparse.available);
  EXPECT_GT(identity.start.distance_m, previous.start.distance_m);
  EXPECT_GT(previous.start.distance_m, sparse.start.distance_m);
  EXPECT_LT(sparse.start.distance_m, 0.01);
  EXPECT_LT(sparse.start.angle_deg, 0.5);
  EXPECT_TRUE(sparse.success && previous.success);
  EXPECT_GT(sparse.inliers, 20);
  EXPECT_GE(sparse.matches, sparse.inliers);
  EXPECT_GT(sparse.milliseconds, 0);
  EXPECT_EQ(identity.milliseconds, 0);
}

TEST(Initialization, SaysWhereAStartIsNotAvailable) {
  const sim::RenderOptions rendering = SmallPictures();
  const tracker::Keyframe keyframe = KeyframeAt(1, rendering);
  Frame blank;
  blank.rgb = Image<Rgb8>(rendering.camera.width, rendering.camera.height, Rgb8{90, 90, 90});
  const auto outcomes = OutcomesOf(blank, keyframe, rendering.camera);
  EXPECT_TRUE(outcomes[0].available && outcomes[1].available);
  EXPECT_FALSE(outcomes[2].available);
  for (const StartOutcome& outcome : outcomes) EXPECT_FALSE(outcome.success);
}

StartOutcome Sparse(bool available, double start_m, bool success, int inliers) {
  StartOutcome outcome;
  outcome.method = StartMethod::kSparse;
  outcome.available = available;
  outcome.start.distance_m = start_m;
  outcome.success = success;
  outcome.inliers = inliers;
  return outcome;
}

TEST(Initialization, SummarizesErrorsWhereThereIsAPoseAndSuccessOverAll) {
  const std::vector<StartOutcome> outcomes = {
      Sparse(true, 0.01, true, 100), Sparse(true, 0.03, false, 20), Sparse(false, 0, false, 0), {}};
  const StartSummary summary = Summarize(StartMethod::kSparse, outcomes);
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
  ASSERT_EQ(rows.size(), 9u);  // three groups of three methods
  EXPECT_EQ(rows[2].at("method"), "sparse");
  EXPECT_EQ(rows[2].at("cases"), 2);
  EXPECT_EQ(rows[2].at("rate"), 1);
  EXPECT_EQ(rows[5].at("gap"), 40);
  EXPECT_EQ(rows[5].at("successes"), 0);
  EXPECT_EQ(rows[8].at("condition"), "blurred");
  const Json cases = CaseRows(records);
  EXPECT_EQ(cases.size(), 4u);
  EXPECT_TRUE(cases[1].at("start_distance_m").is_null());
}

}  // namespace
}  // namespace silt::experiments
