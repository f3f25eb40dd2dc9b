// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/pose_difference.h"

#include <gtest/gtest.h>

namespace silt::experiments {
namespace {

TEST(PoseDifference, IsOfTheCamerasPositionAndRotation) {
  const SE3d world_from_a = SE3d::Exp({{0.4, -0.2, 0.7}, {1, 2, 3}});
  SE3d world_from_b = world_from_a;
  world_from_b.translation += {0.03, 0, -0.04};
  world_from_b.rotation = world_from_b.rotation * Quaterniond::Exp({0, 0.1, 0});
  const PoseDifference difference = Difference(world_from_a.Inverse(), world_from_b.Inverse());
  EXPECT_NEAR(difference.distance_m, 0.05, 1e-12);
  EXPECT_NEAR(difference.angle_deg, 0.1 * 180 / 3.14159265358979, 1e-9);
}

TEST(PoseDifference, IsZeroForEqualPoses) {
  const SE3d pose = SE3d::Exp({{0.4, -0.2, 0.7}, {1, 2, 3}});
  EXPECT_EQ(Difference(pose, pose).distance_m, 0);
  EXPECT_NEAR(Difference(pose, pose).angle_deg, 0, 1e-9);
}

TEST(PoseDifference, IsWithinABoundInBothParts) {
  const PoseDifference bound{0.01, 0.5};
  EXPECT_TRUE((PoseDifference{0.01, 0.5}.Within(bound)));
  EXPECT_FALSE((PoseDifference{0.011, 0.1}.Within(bound)));
  EXPECT_FALSE((PoseDifference{0.001, 0.6}.Within(bound)));
}

}  // namespace
}  // namespace silt::experiments
