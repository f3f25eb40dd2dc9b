// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace silt::sim {
namespace {

TEST(Sampling, SquareSamplesAreCentred) {
  for (const int n : {1, 2, 3, 4, 7, 16, 64}) {
    Vec2d mean;
    for (const Vec2d& p : SquareSamples(n)) {
      mean = mean + 1.0 / n * p;
      EXPECT_GE(std::min(p.x, p.y), 0);
      EXPECT_LT(std::max(p.x, p.y), 1);
    }
    EXPECT_NEAR(mean.x, 0.5, 1e-12) << n;
    EXPECT_NEAR(mean.y, 0.5, 1e-12) << n;
  }
}

// Each of the boxes 2^-a × 2^-(m-a) that tile the square holds exactly one of 2^m points.
TEST(Sampling, SquareSamplesStratifyEveryElementaryInterval) {
  for (const int m : {2, 4, 6}) {
    const int n = 1 << m;
    const std::vector<Vec2d> points = SquareSamples(n);
    for (int a = 0; a <= m; ++a) {
      std::set<std::pair<int, int>> boxes;
      for (const Vec2d& p : points) boxes.insert({int(p.x * (1 << a)), int(p.y * (n >> a))});
      EXPECT_EQ(boxes.size(), std::size_t(n)) << "2^" << m << " points, a = " << a;
    }
  }
}

TEST(Sampling, SquareSamplesFollowNeitherEachOtherNorTheirOrder) {
  const int n = 16;
  const std::vector<Vec2d> points = SquareSamples(n);
  double kx = 0, ky = 0, xy = 0, kk = 0;
  for (int k = 0; k < n; ++k) {
    const double t = (k + 0.5) / n - 0.5, x = points[std::size_t(k)].x - 0.5,
                 y = points[std::size_t(k)].y - 0.5;
    kx += t * x, ky += t * y, xy += x * y, kk += t * t;
  }
  EXPECT_LT(std::abs(kx) / kk, 0.1);
  EXPECT_LT(std::abs(ky) / kk, 0.1);
  EXPECT_LT(std::abs(xy) / kk, 0.1);
}

// Moments of the density cos θ/π: ⟨z⟩ = 2/3, ⟨z²⟩ = 1/2, ⟨x²⟩ = ⟨y²⟩ = 1/4, ⟨x⟩ = ⟨y⟩ = 0.
TEST(Sampling, CosineDirectionsHaveTheMomentsOfTheirDensity) {
  const int n = 256;
  Vec3d first, second;
  for (const Vec3f& d : CosineDirections(n)) {
    EXPECT_NEAR(Norm(d), 1, 1e-6);
    first += (1.0 / n) * d.Cast<double>();
    second += (1.0 / n) * (d * d).Cast<double>();
  }
  EXPECT_NEAR(first.x, 0, 3e-3);
  EXPECT_NEAR(first.y, 0, 3e-3);
  EXPECT_NEAR(first.z, 2.0 / 3, 1e-3);
  EXPECT_NEAR(second.x, 0.25, 3e-3);
  EXPECT_NEAR(second.y, 0.25, 3e-3);
  EXPECT_NEAR(second.z, 0.5, 1e-3);
}

TEST(Sampling, TangentFramesAreOrthonormalAndRightHanded) {
  for (const Vec3f& n : {Vec3f{0, 0, 1}, Vec3f{0, 0, -1}, Vec3f{0.6f, 0, 0.8f},
                         Vec3f{-0.48f, 0.6f, -0.64f}, Vec3f{0, 1, 0}}) {
    const TangentFrame frame(n);
    EXPECT_NEAR(Norm(frame.tangent), 1, 1e-6);
    EXPECT_NEAR(Norm(frame.bitangent), 1, 1e-6);
    EXPECT_NEAR(Dot(frame.tangent, n), 0, 1e-6);
    EXPECT_NEAR(Norm(Cross(frame.tangent, frame.bitangent) - n), 0, 1e-6);
    EXPECT_NEAR(Norm(frame.World({0, 0, 1}) - n), 0, 1e-6);
  }
}

}  // namespace
}  // namespace silt::sim
