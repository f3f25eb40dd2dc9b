// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/lens.h"

#include <gtest/gtest.h>

#include <vector>

namespace silt {
namespace {

// Of a Kinect (TUM fr1), of a wide-angle camera, and with strong tangential terms.
const std::vector<LensDistortion> kLenses{{0.2624, -0.9531, -0.0054, 0.0026, 1.1633},
                                          {-0.28, 0.07, 0.0002, -0.0003, -0.008},
                                          {0.1, 0.02, 0.01, -0.02, 0}};

std::vector<Vec2d> Points() {
  std::vector<Vec2d> points;
  for (double x = -0.6; x <= 0.6; x += 0.15) {
    for (double y = -0.45; y <= 0.45; y += 0.15) points.push_back({x, y});
  }
  return points;
}

TEST(Lens, WithoutCoefficientsLeavesPointsAlone) {
  EXPECT_TRUE(LensDistortion{}.IsNone());
  EXPECT_FALSE(kLenses[0].IsNone());
  const Vec2d p = LensDistortion{}.Distort(Vec2d{0.25, -0.5});
  EXPECT_EQ(p.x, 0.25);
  EXPECT_EQ(p.y, -0.5);
}

// Each coefficient alone, by hand.
TEST(Lens, EachCoefficientDoesItsPart) {
  const Vec2d p{0.5, -0.25};
  const double r2 = 0.3125;
  const auto moved = [&](const LensDistortion& lens) { return lens.Distort(p) - p; };
  EXPECT_DOUBLE_EQ(moved({1, 0, 0, 0, 0}).x, 0.5 * r2);
  EXPECT_DOUBLE_EQ(moved({0, 1, 0, 0, 0}).y, -0.25 * r2 * r2);
  EXPECT_DOUBLE_EQ(moved({0, 0, 0, 0, 1}).x, 0.5 * r2 * r2 * r2);
  EXPECT_DOUBLE_EQ(moved({0, 0, 1, 0, 0}).x, 2 * 0.5 * -0.25);
  EXPECT_DOUBLE_EQ(moved({0, 0, 1, 0, 0}).y, r2 + 2 * 0.0625);
  EXPECT_DOUBLE_EQ(moved({0, 0, 0, 1, 0}).x, r2 + 2 * 0.25);
  EXPECT_DOUBLE_EQ(moved({0, 0, 0, 1, 0}).y, 2 * 0.5 * -0.25);
}

TEST(Lens, UndistortInverts) {
  for (const LensDistortion& lens : kLenses) {
    for (const Vec2d& p : Points()) {
      const Vec2d back = lens.Undistort(lens.Distort(p));
      EXPECT_NEAR(back.x, p.x, 2e-15);
      EXPECT_NEAR(back.y, p.y, 2e-15);
    }
  }
}

TEST(Lens, ProjectsAPointToItsDistortedPixel) {
  const Vec2d pixel =
      ProjectThroughLens(kIclNuimCamera, LensDistortion{0.1, 0, 0, 0, 0}, Vec3d{1, 0, 2});
  EXPECT_DOUBLE_EQ(pixel.x, 481.2 * 0.5 * 1.025 + 319.5);
  EXPECT_DOUBLE_EQ(pixel.y, 239.5);
}

}  // namespace
}  // namespace silt
