// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_rays.h"

#include <gtest/gtest.h>

namespace silt::sim {
namespace {

const SE3d kPose = SE3d::Exp({{0.3, -0.5, 0.7}, {1, 2, 3}});

TEST(CameraRays, PointsAlongARayProjectToItsPixelAndDepth) {
  const PinholeCamera camera = kIclNuimCamera;
  const CameraRays rays(camera, kPose);
  for (const Vec2d& pixel : {Vec2d{0, 0}, Vec2d{639, 479}, Vec2d{12.25, 333.75}}) {
    const double depth = 2.5;
    const Vec3d p = kPose.Inverse() * (rays.origin() + depth * rays.Direction(pixel.x, pixel.y));
    EXPECT_NEAR(p.z, depth, 1e-12);
    EXPECT_NEAR(camera.Project(p).x, pixel.x, 1e-9);
    EXPECT_NEAR(camera.Project(p).y, pixel.y, 1e-9);
  }
}

TEST(CameraRays, PacketsCoverBlocksAndEndWithTheImage) {
  const PinholeCamera camera{100, 110, 4.5, 2.5, 10, 6};
  const CameraRays rays(camera, kPose);
  RayPacket packet;
  rays.Fill(8, 4, {0.25, -0.125}, packet);
  for (int i = 0; i < kPacketSize; ++i) {
    const int x = 8 + i % 4, y = 4 + i / 4;
    EXPECT_EQ(packet.valid[i] != 0, x < 10 && y < 6);
    const Vec3d direction = rays.Direction(x + 0.25, y - 0.125);
    EXPECT_NEAR(packet.direction_x[i], direction.x, 2e-7);
    EXPECT_NEAR(packet.direction_y[i], direction.y, 2e-7);
    EXPECT_NEAR(packet.direction_z[i], direction.z, 2e-7);
    EXPECT_FLOAT_EQ(packet.origin_y[i], float(kPose.translation.y));
  }
}

TEST(CameraRays, PointsAlongARayThroughALensProjectToItsPixelAndDepth) {
  const LensDistortion lens{-0.28, 0.07, 0.002, -0.003, -0.008};
  const LensMap map(kIclNuimCamera, lens);
  const CameraRays rays({kIclNuimCamera, &map}, kPose);
  for (const Vec2d& pixel : {Vec2d{0, 0}, Vec2d{639, 479}, Vec2d{12.25, 333.75}}) {
    const Vec3d p = kPose.Inverse() * (rays.origin() + 2.5 * rays.Direction(pixel.x, pixel.y));
    EXPECT_NEAR(p.z, 2.5, 1e-12);
    EXPECT_NEAR(ProjectThroughLens(kIclNuimCamera, lens, p).x, pixel.x, 1e-9);
    EXPECT_NEAR(ProjectThroughLens(kIclNuimCamera, lens, p).y, pixel.y, 1e-9);
  }
}

TEST(CameraRays, ASingleLaneIsTheRayThroughItsPoint) {
  const CameraRays rays(kIclNuimCamera, kPose);
  RayPacket packet;
  rays.FillLane(5, 17.25, 333.5, packet);
  EXPECT_NE(packet.valid[5], 0);
  EXPECT_FLOAT_EQ(packet.direction_y[5], float(rays.Direction(17.25, 333.5).y));
  EXPECT_FLOAT_EQ(packet.origin_z[5], float(kPose.translation.z));
}

// The chord of an arc of angle θ is off by θ²/8 in its middle.
TEST(CameraRays, BetweenTwoPosesTheyAreThoseOfThePoseInBetween) {
  const double angle = 1e-3;
  const auto at = [&](double t) {
    return CameraRays(kIclNuimCamera, kPose * SE3d::Exp({{0, t * angle, 0}, {}}));
  };
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const CameraRays between(at(0), at(1), t);
    const Vec3d error = between.Direction(100, 50) - at(t).Direction(100, 50);
    EXPECT_LT(Norm(error), 1.5 * angle * angle / 8);
    EXPECT_LT(Norm(between.origin() - at(t).origin()), 1e-12);
  }
}

}  // namespace
}  // namespace silt::sim
