// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/feature_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace silt::tracker {
namespace {

constexpr PinholeCamera kCamera{100, 100, 15.5, 11.5, 32, 24};

// The plane z = 2 + 0.8·x, along which inverse depth is linear in the image.
Image<float> SlantedPlane() {
  Image<float> depth_m(kCamera.width, kCamera.height);
  for (int y = 0; y < depth_m.height(); ++y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      depth_m(x, y) = float(2 / (1 - 0.8 * (x - kCamera.cx) / kCamera.fx));
    }
  }
  return depth_m;
}

TEST(FeaturePoint, IsExactOnASlantedPlane) {
  const Image<float> depth_m = SlantedPlane();
  for (const Vec2d pixel : {Vec2d{10, 10}, Vec2d{10.5, 3.25}, Vec2d{27.9, 20.1}, Vec2d{31, 23}}) {
    const auto point = FeaturePoint(depth_m, kCamera, pixel);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->z, 2 + 0.8 * point->x, 1e-6);
    const Vec2d back = kCamera.Project(*point);
    EXPECT_NEAR(back.x, pixel.x, 1e-9);
    EXPECT_NEAR(back.y, pixel.y, 1e-9);
  }
}

TEST(FeaturePoint, IsNothingAtAnEdge) {
  Image<float> depth_m(kCamera.width, kCamera.height, 1.0f);
  for (int y = 0; y < depth_m.height(); ++y) {
    for (int x = 16; x < depth_m.width(); ++x) depth_m(x, y) = 1.2f;
  }
  EXPECT_FALSE(FeaturePoint(depth_m, kCamera, {15.5, 10}));
  EXPECT_TRUE(FeaturePoint(depth_m, kCamera, {14.5, 10}));
  EXPECT_TRUE(FeaturePoint(depth_m, kCamera, {16.5, 10}));
}

TEST(FeaturePoint, IsNothingWhereDepthIsMissing) {
  for (float missing : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                        std::numeric_limits<float>::infinity()}) {
    Image<float> depth_m = SlantedPlane();
    depth_m(10, 10) = missing;
    EXPECT_FALSE(FeaturePoint(depth_m, kCamera, {9.5, 9.5}));
    EXPECT_TRUE(FeaturePoint(depth_m, kCamera, {11.5, 9.5}));
  }
}

TEST(FeaturePoint, IsNothingOutsideTheImage) {
  const Image<float> depth_m = SlantedPlane();
  for (const Vec2d pixel :
       {Vec2d{-0.1, 5}, Vec2d{32, 5}, Vec2d{5, 24}, Vec2d{5, -3}, Vec2d{std::nan(""), 5}}) {
    EXPECT_FALSE(FeaturePoint(depth_m, kCamera, pixel));
  }
  EXPECT_FALSE(FeaturePoint(Image<float>(), kCamera, {5, 5}));
}

}  // namespace
}  // namespace silt::tracker
