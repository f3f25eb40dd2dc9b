// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/warp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace silt::tracker::kernel {
namespace {

const SE3d kPose = SE3d::Exp({{0.1, -0.2, 0.05}, {0.3, -0.1, 0.2}});

// Algorithm 2, step by step, with core's own types.
TEST(Warp, IsAlgorithm2) {
  const Warp<double> warp(kPose, kIclNuimCamera);
  for (const double depth : {0.4, 1.7, 30.0}) {
    const Vec3d reference_point = kIclNuimCamera.Unproject(100, 200, depth);
    const Vec3d current_point = kPose * reference_point;
    const Vec2d expected = kIclNuimCamera.Project(current_point);
    const WarpedPixel<double> warped = WarpPixel<double>(warp, {100, 200, depth, 0});
    EXPECT_TRUE(warped.front);
    EXPECT_NEAR(Norm(warped.point - current_point), 0, 1e-13);
    EXPECT_NEAR(warped.inverse_z, 1 / current_point.z, 1e-13);
    EXPECT_NEAR(warped.u, expected.x, 1e-10);
    EXPECT_NEAR(warped.v, expected.y, 1e-10);
  }
}

TEST(Warp, IdentityKeepsThePixel) {
  const Warp<float> warp(Warp<double>(SE3d{}, kIclNuimCamera));
  const WarpedPixel<float> warped = WarpPixel<float>(warp, {37, 411, 2.5f, 0});
  EXPECT_NEAR(warped.u, 37, 1e-4);
  EXPECT_NEAR(warped.v, 411, 1e-4);
}

TEST(Warp, NeedsAMeasuredDepth) {
  const Warp<float> warp(Warp<double>(SE3d{}, kIclNuimCamera));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float depth : {0.0f, -1.0f, nan, std::numeric_limits<float>::infinity(), 1e6f}) {
    const WarpedPixel<float> warped = WarpPixel<float>(warp, {10, 10, depth, 0});
    EXPECT_FALSE(warped.front) << depth;
    EXPECT_TRUE(std::isfinite(warped.inverse_z)) << depth;
  }
}

TEST(Warp, TellsWhatLiesBehindTheCamera) {
  const Warp<double> warp({{}, {0, 0, -2}}, kIclNuimCamera);
  EXPECT_FALSE(WarpPixel<double>(warp, {10, 10, 1.9, 0}).front);
  EXPECT_FALSE(WarpPixel<double>(warp, {10, 10, 2.0005, 0}).front);
  EXPECT_TRUE(WarpPixel<double>(warp, {10, 10, 2.1, 0}).front);
}

}  // namespace
}  // namespace silt::tracker::kernel
