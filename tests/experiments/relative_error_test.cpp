// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/relative_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace silt::experiments {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kPoses = 11;

// Pose after pose by the same step in the camera's own axes.
Trajectory Walk(const SE3d& step, int poses = kPoses) {
  Trajectory trajectory;
  SE3d pose = SE3d::Exp({{1, 2, 3}, {4, 5, 6}});
  for (int i = 0; i < poses; ++i, pose = pose * step) trajectory.push_back({0.1 * i, pose});
  return trajectory;
}

// The truth walks 1 m a step along x; the estimate 1.01 m and turns by 1° about z.
const SE3d kTrueStep{{}, {1, 0, 0}};
const SE3d kEstimatedStep{Quaterniond::Exp({0, 0, kDegree}), {1.01, 0, 0}};

// With N the true and M the estimated step, N⁻¹·M moves by 1 cm.
TEST(RelativePoseError, OfOneFrameLikeEvo) {
  const auto error = RelativePoseError(Walk(kTrueStep), Walk(kEstimatedStep),
                                       {1, WindowUnit::kFrames}, Convention::kEvo);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->translation_m.count, 10);
  EXPECT_NEAR(error->translation_m.rmse, 0.01, 1e-12);
  EXPECT_NEAR(error->rotation_deg.max, 1, 1e-10);
  EXPECT_NEAR(error->rotation_deg.min, 1, 1e-10);
}

// TUM's script composes inverse motions: M·N⁻¹ = (R, 1.01·eₓ − R·eₓ).
TEST(RelativePoseError, OfOneFrameLikeTum) {
  const auto error = RelativePoseError(Walk(kTrueStep), Walk(kEstimatedStep),
                                       {1, WindowUnit::kFrames}, Convention::kTum);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->translation_m.count, 9);  // none may end at the last pose
  const double along = 1.01 - std::cos(kDegree), across = std::sin(kDegree);
  EXPECT_NEAR(error->translation_m.mean, std::hypot(along, across), 1e-12);
  EXPECT_NEAR(error->rotation_deg.mean, 1, 1e-10);
}

struct WindowCase {
  Window window;
  int evo, tum;  // how many windows there are
};

void PrintTo(const WindowCase& each, std::ostream* out) {
  *out << each.window.length
       << (each.window.unit == WindowUnit::kFrames    ? " frames"
           : each.window.unit == WindowUnit::kSeconds ? " s"
                                                      : " m");
}

class Windows : public testing::TestWithParam<WindowCase> {};

TEST_P(Windows, AreAsManyAsTheRuleGives) {
  const Trajectory truth = Walk(kTrueStep), estimate = Walk(kEstimatedStep);
  const auto count = [&](Convention convention) {
    const auto error = RelativePoseError(truth, estimate, GetParam().window, convention);
    return error ? error->translation_m.count : 0;
  };
  EXPECT_EQ(count(Convention::kEvo), GetParam().evo);
  EXPECT_EQ(count(Convention::kTum), GetParam().tum);
}

INSTANTIATE_TEST_SUITE_P(
    OfElevenPoses, Windows,
    testing::Values(
        // evo: 0-5, 5-10; TUM: 0-5 … 4-9.
        WindowCase{{5, WindowUnit::kFrames}, 2, 5},
        // Of 0.1 s a pose, although ten times 0.1 is not 1 in binary.
        WindowCase{{0.3, WindowUnit::kSeconds}, 3, 7}, WindowCase{{1, WindowUnit::kSeconds}, 1, 0},
        // 1.01 m a pose: evo's ends are poses 2, 4, 6, 8, 10, its first window starting at 2.
        WindowCase{{2, WindowUnit::kMetres}, 4, 8}, WindowCase{{50, WindowUnit::kFrames}, 0, 0}));

TEST(RelativePoseError, OfAnExactEstimateInAnotherWorldIsNothing) {
  const Trajectory truth = Walk(kEstimatedStep);
  Trajectory estimate = truth;
  const SE3d elsewhere = SE3d::Exp({{0, 1, 0}, {9, 9, 9}});
  for (StampedPose& pose : estimate) pose.world_from_camera = elsewhere * pose.world_from_camera;
  for (const Convention convention : {Convention::kEvo, Convention::kTum}) {
    const auto error = RelativePoseError(truth, estimate, {2, WindowUnit::kFrames}, convention);
    ASSERT_TRUE(error);
    EXPECT_LT(error->translation_m.max, 1e-12);
    EXPECT_LT(error->rotation_deg.max, 1e-10);
  }
}

TEST(RelativePoseError, LikeTumLeavesOutWindowsThatEndInAGapOfTheTruth) {
  Trajectory truth = Walk(kTrueStep);
  const Trajectory estimate = Walk(kEstimatedStep);
  // Without poses 3 to 7 the truth nearest to pose 5 is 0.3 s away, more than two intervals of 0.1
  // s.
  truth.erase(truth.begin() + 3, truth.begin() + 8);
  const auto error = RelativePoseError(truth, estimate, {1, WindowUnit::kFrames}, Convention::kTum);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->translation_m.count, 7);  // of nine, 4-5 and 5-6 are gone
}

TEST(RelativePoseError, OfNothingIsNothing) {
  for (const Convention convention : {Convention::kEvo, Convention::kTum}) {
    EXPECT_FALSE(RelativePoseError({}, {}, {}, convention));
    EXPECT_FALSE(RelativePoseError(Walk(kTrueStep, 1), Walk(kTrueStep, 1), {}, convention));
  }
}

}  // namespace
}  // namespace silt::experiments
