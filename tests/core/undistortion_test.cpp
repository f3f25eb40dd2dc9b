// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/undistortion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/error.h"

namespace silt {
namespace {

constexpr PinholeCamera kCamera{150, 152, 80.25, 58.5, 160, 120};
constexpr LensDistortion kBarrel{-0.25, 0.06, 0.002, -0.001, 0};

// Smooth pictures as functions of where a ray points.
double Brightness(const Vec2d& ray) { return 128 + 60 * std::sin(9 * ray.x) * std::cos(7 * ray.y); }
double Depth(const Vec2d& ray) { return 2 / (1 + 0.3 * ray.x - 0.2 * ray.y); }

// The frame of a camera with a lens, by inverting it for each pixel.
Frame Seen(const LensDistortion& lens) {
  Frame frame{3.5, {kCamera.width, kCamera.height}, {kCamera.width, kCamera.height}};
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const Vec2d ray =
          lens.Undistort(Vec2d{(x - kCamera.cx) / kCamera.fx, (y - kCamera.cy) / kCamera.fy});
      const auto code = std::uint8_t(std::lround(Brightness(ray)));
      frame.rgb(x, y) = {code, std::uint8_t(255 - code), 7};
      frame.depth_m(x, y) = float(Depth(ray));
    }
  }
  return frame;
}

TEST(Undistortion, MakesThePinholesFrame) {
  const Frame straight = Seen({}),
              undistorted = Undistortion(kCamera, kBarrel).Apply(Seen(kBarrel));
  EXPECT_EQ(undistorted.time_s, 3.5);
  int far_off = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      far_off += std::abs(undistorted.rgb(x, y).r - straight.rgb(x, y).r) > 1;
      EXPECT_NEAR(undistorted.rgb(x, y).g, straight.rgb(x, y).g, 2);
      EXPECT_EQ(undistorted.rgb(x, y).b, 7);
      EXPECT_NEAR(undistorted.depth_m(x, y), straight.depth_m(x, y), 2e-4);
    }
  }
  EXPECT_LT(far_off, 0.01 * kCamera.width * kCamera.height);
}

TEST(Undistortion, WithoutALensChangesNothing) {
  const Frame straight = Seen({}), same = Undistortion(kCamera, {}).Apply(straight);
  EXPECT_EQ(same.rgb, straight.rgb);
  for (std::size_t i = 0; i < same.depth_m.size(); ++i) {
    EXPECT_NEAR(same.depth_m.data()[i], straight.depth_m.data()[i], 1e-6);
  }
}

// A pincushion lens sees less than the pinhole.
TEST(Undistortion, WhatWasNotSeenIsBlackAndWithoutDepth) {
  const Frame out = Undistortion(kCamera, {0.2, 0, 0, 0, 0}).Apply(Seen({0.2, 0, 0, 0, 0}));
  EXPECT_EQ(out.rgb(0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(out.depth_m(0, 0), 0);
  EXPECT_EQ(out.rgb(80, 60).b, 7);
  EXPECT_GT(out.depth_m(80, 60), 0);
}

TEST(Undistortion, NoDepthLiesBetweenSurfacesOrBesideNone) {
  Frame frame = Seen(kBarrel);
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x)
      frame.depth_m(x, y) = x % 3 == 0 ? 0 : x % 3 == 1 ? 1 : 4;
  }
  for (const float z : Undistortion(kCamera, kBarrel).Apply(frame).depth_m) {
    EXPECT_TRUE(std::abs(z) < 1e-6f || std::abs(z - 1) < 1e-6f || std::abs(z - 4) < 1e-6f) << z;
  }
}

TEST(Undistortion, TakesAFrameWithoutDepthAndRefusesAnotherSize) {
  const Undistortion undistortion(kCamera, kBarrel);
  Frame frame = Seen(kBarrel);
  frame.depth_m = {};
  EXPECT_TRUE(undistortion.Apply(frame).depth_m.empty());
  EXPECT_EQ(undistortion.Apply(frame).rgb.width(), kCamera.width);
  frame.rgb = Image<Rgb8>(20, 20);
  EXPECT_THROW(undistortion.Apply(frame), Error);
}

}  // namespace
}  // namespace silt
