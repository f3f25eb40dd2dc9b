// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/convergence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/convergence_report.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/experiments/success_rate.h"
#include "silt/tracker/cpu_backend.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

// Frames of the studio, 0.15 s apart.
class Convergence : public testing::Test {
 protected:
  static void SetUpTestSuite() { backend_ = tracker::MakeCpuBackend().release(); }
  static void TearDownTestSuite() { delete backend_; }

  static std::vector<PairAlignment> Pairs() {
    std::vector<PairAlignment> pairs;
    pairs.emplace_back(*backend_, RenderPair(StudioWorld(), SmallPictures(), 1, 1.15), 4);
    return pairs;
  }

  static inline const tracker::Backend* backend_ = nullptr;
};

TEST(PaperStart, KeepsTheRotationAndShortensTheTranslation) {
  const SE3d truth = SE3d::Exp({{0.1, 0.2, -0.1}, {0.5, -0.2, 0.3}});
  const SE3d start = PaperStart(truth);
  EXPECT_EQ(start.rotation.w, truth.rotation.w);
  EXPECT_NEAR(Norm(start.translation - 0.6 * truth.translation), 0, 1e-15);
}

TEST(RenderPairTest, HasTheTrueMotionAndRefusesTimesBeyondThePath) {
  const World& world = StudioWorld();
  const FramePair pair = RenderPair(world, SmallPictures(64), 0.5, 1);
  const SE3d world_from_current =
      world.path.WorldFromCamera(0.5) * pair.current_from_reference.Inverse();
  EXPECT_NEAR(Norm(world_from_current.translation - world.path.WorldFromCamera(1).translation), 0,
              1e-12);
  EXPECT_EQ(pair.reference.time_s, 0.5);
  EXPECT_THROW(RenderPair(world, SmallPictures(64), 0, 1000), Error);
  EXPECT_THROW(RenderPair(world, SmallPictures(64), -0.1, 0), Error);
}

TEST_F(Convergence, BothSchemesReachTheTruthFromThePapersStart) {
  const std::vector<ConvergenceRun> runs = RunPaperConvergence(Pairs().front());
  ASSERT_EQ(runs.size(), 2u);
  for (const ConvergenceRun& run : runs) {
    ASSERT_TRUE(run.result.ok) << run.scheme << ": " << run.result.failure;
    EXPECT_GT(run.start_error.distance_m, 5e-3);
    EXPECT_LT(run.end_error.distance_m, 0.4 * run.start_error.distance_m) << run.scheme;
    for (const tracker::AlignmentLevel& level : run.result.levels) {
      EXPECT_LE(level.final_cost.mean(), level.initial_cost.mean());
    }
  }
  EXPECT_EQ(runs[0].result.levels.size(), 1u);
  EXPECT_EQ(runs[1].result.levels.size(), 4u);
  EXPECT_LE(runs[0].result.levels[0].iterations, 100);
}

TEST_F(Convergence, IsReportedBesideThePapersFigures) {
  const std::vector<ConvergenceRun> runs = RunPaperConvergence(Pairs().front());
  const Json levels = LevelRows(runs);
  ASSERT_EQ(levels.size(), 5u);
  EXPECT_EQ(levels[0].at("paper_initial_cost"), 4386.8);
  EXPECT_EQ(levels[1].at("level"), 4);
  EXPECT_NEAR(levels[1].at("paper_ratio").get<double>(), 24.27 / 2.47, 1e-12);
  EXPECT_NEAR(levels[4].at("ratio").get<double>(),
              levels[4].at("initial_cost").get<double>() / levels[4].at("final_cost").get<double>(),
              1e-12);
  std::size_t solves = 0;
  for (const Json& level : levels) solves += level.at("solves").get<std::size_t>();
  EXPECT_EQ(IterationRows(runs).size(), solves);
  EXPECT_THAT(FormatConvergence(runs, {}), HasSubstr("full resolution only"));
}

TEST_F(Convergence, SucceedsFromNearAndFailsFromFarAway) {
  const std::vector<PairAlignment> pairs = Pairs();
  const SuccessRate near = MeasureSuccessRate(pairs, {{0.002, 0.1}, 4, 1}, PyramidScheme());
  const SuccessRate far = MeasureSuccessRate(pairs, {{1.5, 60}, 4, 1}, PyramidScheme());
  EXPECT_EQ(near.starts, 4);
  EXPECT_GE(near.recovered, 3);
  EXPECT_EQ(far.recovered, 0);
  EXPECT_GT(near.median_solves, 0);
  const Json rows = SuccessRows({{kPyramid, "both", near}, {kPyramid, "both", far}});
  EXPECT_EQ(rows[0].at("rate"), near.rate());
  EXPECT_LT(rows[1].at("rate_high").get<double>(), 0.6);
}

TEST_F(Convergence, IsTheSameEveryTime) {
  const std::vector<PairAlignment> pairs = Pairs();
  const auto rows = [&] { return IterationRows(RunPaperConvergence(pairs.front())).dump(); };
  EXPECT_EQ(rows(), rows());
}

}  // namespace
}  // namespace silt::experiments
