// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/nguyen_depth.h"

#include <gtest/gtest.h>

#include "depth_scene.h"

namespace silt::sim {
namespace {

constexpr double kDegree = M_PI / 180;

// The figures of the formulas, worked out by hand.
TEST(NguyenDepth, FormulasAreThoseOfThePaper) {
  EXPECT_NEAR(NguyenDepth::AxialSigma(0.4, 0), 0.0012, 1e-12);
  EXPECT_NEAR(NguyenDepth::AxialSigma(2.4, 0), 0.0088, 1e-12);
  // θ = 60°: θ/(π/2 − θ) = 2.
  EXPECT_NEAR(NguyenDepth::AxialSigma(1, 60 * kDegree), 0.0012 + 0.0019 * 0.36 + 0.0004, 1e-12);
  EXPECT_NEAR(NguyenDepth::AxialSigma(4, 60 * kDegree), 0.0012 + 0.0019 * 12.96 + 0.0002, 1e-12);
  EXPECT_NEAR(NguyenDepth::LateralSigma(0), 0.8, 1e-12);
  EXPECT_NEAR(NguyenDepth::LateralSigma(60 * kDegree), 0.87, 1e-12);
}

TEST(NguyenDepth, AxialNoiseFollowsDepthAndAngleAtTwelvePlaces) {
  for (const double z : {0.5, 1.0, 2.0, 3.5}) {
    for (const double degrees : {0.0, 45.0, 78.0}) {
      const double theta = degrees * kDegree, sigma = NguyenDepth::AxialSigma(z, theta);
      const Image<float> measured = Measured({"nguyen", {}}, Wall(z, theta));
      ExpectMeanAndVariance(Values([&](int x, int y) { return double(measured(x, y)); }), z,
                            sigma * sigma);
    }
  }
}

// On a slope, lateral noise shows as depth.
TEST(NguyenDepth, LateralNoiseMovesPixelsAlongRowsAndColumns) {
  const double slope = 0.01, theta = 70 * kDegree, sigma = NguyenDepth::LateralSigma(theta);
  for (const bool along_x : {true, false}) {
    const auto depth = [&](int x, int y) { return 1 + slope * (along_x ? x : y); };
    const GeometryBuffers truth = Geometry(depth, theta);
    const Image<float> measured = Measured({"nguyen", {}}, truth);
    double squares = 0, expected = 0;
    for (int y = 8; y < kHeight - 8; ++y) {
      for (int x = 8; x < kWidth - 8; ++x) {
        const double e = double(measured(x, y)) - depth(x, y);
        squares += e * e;
        const double axial = NguyenDepth::AxialSigma(depth(x, y), theta);
        expected += axial * axial + slope * slope * sigma * sigma;
      }
    }
    EXPECT_NEAR(squares / expected, 1, 0.05);
  }
}

// Depth comes from before or behind an edge, never from between, up to the axial noise.
TEST(NguyenDepth, NoPointFliesBetweenSurfaces) {
  const GeometryBuffers truth = Geometry([](int x, int) { return x < 128 ? 1.0 : 2.0; });
  int before = 0, behind = 0;
  const Image<float> measured = Measured({"nguyen", {}}, truth);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double z = double(measured(x, y));
      EXPECT_LT(std::min(std::abs(z - 1), std::abs(z - 2)), 0.04);
      before += z < 1.5 && x >= 128;
      behind += z > 1.5 && x < 128;
    }
  }
  // A pixel's centre lies ½ px from the edge at least: P(N(0, 0.8) > ½) + P(> 1½) + … = 0.299 of
  // 256.
  EXPECT_NEAR(before, 76, 40);
  EXPECT_NEAR(behind, 76, 40);
}

}  // namespace
}  // namespace silt::sim
