// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/odometry_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "studio_world.h"

namespace silt::experiments {
namespace {

constexpr PinholeCamera kCamera{100, 100, 4, 3, 9, 7};

// A wall 2 m away, each pixel of its own gray.
Frame Wall() {
  Frame wall{0, Image<Rgb8>(9, 7), Image<float>(9, 7, 2.0f)};
  for (int i = 0; i < 63; ++i) {
    const auto gray = std::uint8_t(4 * i);
    wall.rgb.data()[i] = {gray, gray, gray};
  }
  return wall;
}

TEST(TrialMotion, StaysWithinItsBoundsAndReachesThem) {
  double turn = 0, shift = 0, least_turn = 1, least_shift = 1;
  for (int i = 0; i < 300; ++i) {
    const SE3d motion = TrialMotion(1, i);
    turn = std::max(turn, RotationAngle(motion.rotation));
    shift = std::max(shift, Norm(motion.translation));
    least_turn = std::min(least_turn, RotationAngle(motion.rotation));
    least_shift = std::min(least_shift, Norm(motion.translation));
  }
  EXPECT_LE(turn, kTrialMaxTurn_rad * (1 + 1e-12));
  EXPECT_LE(shift, kTrialMaxShift_m * (1 + 1e-12));
  EXPECT_GT(turn, 0.97 * kTrialMaxTurn_rad);
  EXPECT_GT(shift, 0.97 * kTrialMaxShift_m);
  EXPECT_GE(least_turn, kTrialMinTurn_rad * (1 - 1e-12));
  EXPECT_GE(least_shift, kTrialMinShift_m * (1 - 1e-12));
  EXPECT_LT(least_turn, 1.2 * kTrialMinTurn_rad);
}

// 4 cm at 2 m and 100 px are 2 px.
TEST(ForwardWarp, ShiftsAWallAndFillsOnePixelOfWhatItUncovers) {
  const Frame wall = Wall(), warped = ForwardWarp(wall, kCamera, {{}, {0.04, 0, 0}});
  for (int y = 0; y < 7; ++y) {
    for (int x = 2; x < 9; ++x) {
      EXPECT_EQ(warped.rgb(x, y).g, wall.rgb(x - 2, y).g);
      EXPECT_FLOAT_EQ(warped.depth_m(x, y), 2);
    }
    EXPECT_FLOAT_EQ(warped.depth_m(1, y), 2);
    EXPECT_EQ(warped.depth_m(0, y), 0);
  }
  // Between the pixels (2, 2) to (2, 4), which were (0, 2) to (0, 4).
  EXPECT_EQ(warped.rgb(1, 3).g, (wall.rgb(0, 2).g + wall.rgb(0, 4).g) / 2);
}

TEST(ForwardWarp, KeepsTheNearestOfWhatLandsOnAPixel) {
  Frame wall = Wall();
  wall.depth_m(2, 3) = 1;  // 1 m away it moves 4 px, to where (4, 3) lands
  const Frame warped = ForwardWarp(wall, kCamera, {{}, {0.04, 0, 0}});
  EXPECT_FLOAT_EQ(warped.depth_m(6, 3), 1);
  EXPECT_EQ(warped.rgb(6, 3).g, wall.rgb(2, 3).g);
}

TEST(OdometryTrial, CountsErrorsBelowBounds) {
  const OdometryTrial trial{
      "", "", {{0.05, 0.02, 1e-5, 1e-5}, {0.05, 0.02, 1e-3, 0.03}, {1, 1, 2, 0}}};
  EXPECT_EQ(trial.BelowMotion(), 1);
  EXPECT_EQ(trial.Below(4e-3, 4e-3), 1);
  EXPECT_EQ(trial.Below(1e-4, 1e-4), 1);
  EXPECT_EQ(trial.Below(1e-2, 1e-1), 2);
  EXPECT_EQ(trial.Worst().error_rad, 2);
  EXPECT_EQ(trial.Worst().error_m, 0.03);
}

constexpr int kMotions = 12;

class OpencvsTest : public testing::TestWithParam<const char*> {};

// Some of the hundred motions, which the experiment runs all: each takes about half a second of
// rendering and tracking.
TEST_P(OpencvsTest, IsPassed) {
  const sim::RenderOptions rendering = SmallPictures(640);
  const sim::Renderer renderer(StudioWorld().scene, rendering);
  const SE3d world_from_frame = StudioWorld().path.WorldFromCamera(1);
  const MovedFrame rendered = [&](const SE3d& current_from_frame) {
    const SE3d pose = world_from_frame * current_from_frame.Inverse();
    return renderer.Render([&](double) { return pose; }, 1, 0);
  };
  const Frame frame = rendered(SE3d{});
  const auto run = [&](const MovedFrame& moved) {
    return RunTrial(frame, rendering.camera, moved, GetParam(), kMotions, 3);
  };
  const OdometryTrial warped = run([&](const SE3d& current_from_frame) {
    return ForwardWarp(frame, rendering.camera, current_from_frame);
  });
  EXPECT_EQ(warped.BelowMotion(), kMotions);
  EXPECT_EQ(warped.Below(4e-3, 4e-3), kMotions);
  EXPECT_EQ(run(rendered).Below(1e-4, 1e-4), kMotions);
  EXPECT_EQ(TrialRows({warped})[0].at("below_motion"), kMotions);
}

INSTANTIATE_TEST_SUITE_P(Presets, OpencvsTest, testing::Values("accurate", "fast"));

}  // namespace
}  // namespace silt::experiments
