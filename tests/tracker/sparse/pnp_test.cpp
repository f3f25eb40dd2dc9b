// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/pnp.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt::tracker {
namespace {

const SE3d kTruth = SE3d::Exp({{0.1, -0.2, 0.15}, {0.12, -0.05, 0.08}});

// Points before the keyframe's camera, from 1 m to 1 + `deep_m`, and their images with `noise_px`.
PnpProblem Problem(int count, double deep_m, double noise_px = 0) {
  const CounterRandom random(4), noise(5);
  PnpProblem problem{kIclNuimCamera, {}, {}};
  for (int i = 0; i < count; ++i) {
    const auto draw = std::uint64_t(3 * i);
    problem.points.push_back(kIclNuimCamera.Unproject(640 * random.Uniform(draw),
                                                      480 * random.Uniform(draw + 1),
                                                      1 + deep_m * random.Uniform(draw + 2)));
    Vec2d pixel = kIclNuimCamera.Project(kTruth * problem.points.back());
    pixel = pixel + Vec2d{noise_px * noise.Normal(draw), noise_px * noise.Normal(draw + 1)};
    problem.pixels.push_back(pixel);
  }
  return problem;
}

void ExpectPose(const SE3d& pose, double tolerance) {
  const SE3d error = pose * kTruth.Inverse();
  EXPECT_LT(Norm(error.translation), tolerance);
  EXPECT_LT(RotationAngle(error.rotation), tolerance);
}

TEST(Pnp, IsExactWithoutNoise) {
  for (double deep_m : {2.0, 0.0}) {  // in space; on a plane
    const auto solution = SolvePnp(Problem(40, deep_m));
    ASSERT_TRUE(solution);
    EXPECT_EQ(solution->inliers.size(), 40u);
    EXPECT_LT(solution->rmse_px, 1e-4);
    ExpectPose(solution->current_from_keyframe, 1e-6);
  }
}

TEST(Pnp, LeavesOutliersOut) {
  PnpProblem problem = Problem(100, 2, 0.3);
  const CounterRandom random(6);
  for (std::size_t i = 0; i < 40; ++i) {
    problem.pixels[i] = {640 * random.Uniform(2 * i), 480 * random.Uniform(2 * i + 1)};
  }
  const auto solution = SolvePnp(problem);
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->inliers.size(), 60u);
  EXPECT_EQ(solution->inliers.front(), 40);
  EXPECT_NEAR(solution->rmse_px, 0.3 * std::sqrt(2), 0.08);
  ExpectPose(solution->current_from_keyframe, 2e-3);
}

// With σ = 0.5 px on 200 points about 2 m away, 0.5 mm and 0.3 mrad are expected.
TEST(Pnp, AveragesNoiseOverTheInliers) {
  const auto solution = SolvePnp(Problem(200, 2, 0.5));
  ASSERT_TRUE(solution);
  ExpectPose(solution->current_from_keyframe, 1.5e-3);
}

TEST(Pnp, IsNothingWithTooFewInliers) {
  EXPECT_FALSE(SolvePnp({kIclNuimCamera, {}, {}}));
  EXPECT_FALSE(SolvePnp(Problem(11, 2)));
  EXPECT_TRUE(SolvePnp(Problem(12, 2)));
  PnpProblem nonsense = Problem(60, 2);
  const CounterRandom random(8);
  for (std::size_t i = 0; i < 60; ++i) {
    nonsense.pixels[i] = {640 * random.Uniform(2 * i), 480 * random.Uniform(2 * i + 1)};
  }
  EXPECT_FALSE(SolvePnp(nonsense));
}

TEST(Pnp, SurvivesDegeneratePoints) {
  PnpProblem problem = Problem(30, 2);
  for (Vec3d& point : problem.points) point = problem.points[0];
  for (Vec2d& pixel : problem.pixels) pixel = problem.pixels[0];
  const auto solution = SolvePnp(problem);  // any pose that is finite will do
  if (solution) {
    EXPECT_TRUE(std::isfinite(Norm(solution->current_from_keyframe.translation)));
  }
}

TEST(Pnp, RejectsOptionsOutOfRange) {
  EXPECT_THROW(SolvePnp(Problem(20, 2), {0, 500, 0.999, 12}), Error);
  EXPECT_THROW(SolvePnp(Problem(20, 2), {2, 0, 0.999, 12}), Error);
  EXPECT_THROW(SolvePnp(Problem(20, 2), {2, 500, 1, 12}), Error);
  EXPECT_THROW(SolvePnp(Problem(20, 2), {2, 500, 0.999, 3}), Error);
}

}  // namespace
}  // namespace silt::tracker
