// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "key_poses.h"
#include "silt/core/error.h"
#include "silt/sim/spline.h"

namespace silt::sim {
namespace {

// The largest distance of the spline from its keys, in metres or radians.
double LargestMiss(const PoseSpline& spline, const Trajectory& keys) {
  double miss = 0;
  for (const StampedPose& key : keys) {
    miss = std::max(miss, PoseDistance(spline.At(key.time_s), key.world_from_camera));
  }
  return miss;
}

double Length(const PoseSpline& spline) {
  Trajectory samples;
  for (double t = 0; t < spline.end_s(); t += 1e-3) samples.push_back({t, spline.At(t)});
  return PathLength(samples);
}

class SplineOfKeys : public testing::TestWithParam<int> {};

TEST_P(SplineOfKeys, PassesThroughThem) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Trajectory keys = RandomKeys(GetParam(), 0.8, seed);
    EXPECT_LT(LargestMiss(PoseSpline::Through(keys), keys), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, SplineOfKeys, testing::Values(2, 3, 4, 5, 30, 1000));

TEST(SplineFit, PassesThroughKeysThatTurnFar) {
  Trajectory keys = RandomKeys(20, 0.3);
  for (int i = 0; i < 20; ++i) {
    Quaterniond& rotation = keys[i].world_from_camera.rotation;
    rotation = Quaterniond::Exp({0, 0, std::numbers::pi / 2 * i}) * rotation;
    keys[i].time_s = i;
  }
  EXPECT_LT(LargestMiss(PoseSpline::Through(keys), keys), 1e-9);
}

// The check above must be able to fail: control poses that are not solved for cut the corners.
TEST(SplineFit, UnfittedMissesTheKeysAndShrinksThePath) {
  const Trajectory keys = RandomKeys(30);
  const PoseSpline unfitted = PoseSpline::WithControls(keys);
  EXPECT_GT(LargestMiss(unfitted, keys), 0.05);
  EXPECT_LT(Length(unfitted), 0.9 * Length(PoseSpline::Through(keys)));
}

TEST(SplineFit, LeavesEvenMotionAsItIs) {
  Trajectory keys;
  for (int i = 0; i < 5; ++i) {
    keys.push_back({0.5 * i, {Quaterniond::Exp({0, 0.1 * i, 0}), {0.2 * i, 0, 1}}});
  }
  const Trajectory controls = SolveControls(keys);
  for (int i = 0; i < 5; ++i) {
    EXPECT_LT(PoseDistance(controls[i].world_from_camera, keys[i].world_from_camera), 1e-12);
  }
}

TEST(SplineFit, RefusesKeysThatSwingTooFar) {
  Trajectory keys;
  for (int i = 0; i < 8; ++i) {
    keys.push_back({double(i), {Quaterniond::Exp({0, 0, i % 2 ? 2.9 : 0.0}), {}}});
  }
  try {
    SolveControls(keys);
    ADD_FAILURE() << "was fitted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::ContainsRegex("key pose at [1-6].000000 s"));
  }
}

}  // namespace
}  // namespace silt::sim
