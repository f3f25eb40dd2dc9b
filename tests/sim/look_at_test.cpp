// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/look_at.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::sim {
namespace {

TEST(LookAt, SeesTheTargetInTheMiddleWithTheWorldUpright) {
  const Vec3d position{1, 2, 1.5}, target{-0.5, 3, 0.2};
  const SE3d camera_from_world = LookAt(position, target).Inverse();
  const Vec3d seen = camera_from_world * target;
  EXPECT_NEAR(seen.x, 0, 1e-14);
  EXPECT_NEAR(seen.y, 0, 1e-14);
  EXPECT_NEAR(seen.z, Norm(target - position), 1e-14);
  const Vec3d up = camera_from_world.rotation * Vec3d{0, 0, 1};
  EXPECT_NEAR(up.x, 0, 1e-14);
  EXPECT_LT(up.y, 0);  // y is down
}

TEST(LookAt, NorthwardsHasEastOnItsRight) {
  const SE3d world_from_camera = LookAt({0, 0, 0}, {0, 1, 0});
  EXPECT_LT(Norm(world_from_camera.rotation * Vec3d{1, 0, 0} - Vec3d{1, 0, 0}), 1e-15);
  EXPECT_LT(Norm(world_from_camera.rotation * Vec3d{0, 1, 0} - Vec3d{0, 0, -1}), 1e-15);
}

TEST(LookAt, AVerticalViewHasNoHeading) {
  EXPECT_TRUE(HasHeading({0, 1, 0}));
  EXPECT_TRUE(HasHeading({0, std::sin(1.1 * kLeastTilt_rad), -1}));
  EXPECT_FALSE(HasHeading({0, std::sin(0.9 * kLeastTilt_rad), -1}));
  EXPECT_FALSE(HasHeading({0, 0, 1}));
  EXPECT_FALSE(HasHeading({0, 0, 0}));
  EXPECT_FALSE(HasHeading({NAN, 1, 0}));
}

}  // namespace
}  // namespace silt::sim
