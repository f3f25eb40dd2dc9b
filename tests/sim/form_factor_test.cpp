// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/form_factor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::sim {
namespace {

// 2a × 2b, at height h, facing down.
RectLight Ceiling(float a, float b, float h) { return {{0, 0, h}, {0, b, 0}, {a, 0, 0}, {}}; }

// ∫ cos θ dω of a rectangle seen from a point opposite to its corner (Howell's catalogue, C-11):
// ½ [A/√(1+A²)·atan(B/√(1+A²)) + B/√(1+B²)·atan(A/√(1+B²))], A = a/h, B = b/h.
double CornerFactor(double a, double b) {
  const double ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
  return 0.5 * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
}

// ∫ cos θ cos θ'/r² dA by the midpoint rule.
double Integrated(const RectLight& light, const Vec3d& point, const Vec3d& normal) {
  constexpr int n = 400;
  const Vec3d u = light.half_u.Cast<double>(), v = light.half_v.Cast<double>();
  const Vec3d facing = Cross(u, v);
  double sum = 0;
  for (int i = 0; i < n * n; ++i) {
    const double s = 2 * (i % n + 0.5) / n - 1, t = 2 * (double(i / n) + 0.5) / n - 1;
    const Vec3d way = light.center.Cast<double>() + s * u + t * v - point;
    const double r_sq = Dot(way, way);
    sum += std::fmax(0, Dot(way, normal)) * std::fmax(0, -Dot(way, facing)) / (r_sq * r_sq);
  }
  return 4 * sum / (n * n);
}

TEST(FormFactor, MatchesTheCatalogueBelowTheCentre) {
  EXPECT_NEAR(RectangleFormFactor(Ceiling(1, 0.5f, 2), {0, 0, 0}, {0, 0, 1}),
              4 * CornerFactor(0.5, 0.25), 1e-12);
}

TEST(FormFactor, MatchesTheIntegralAtTiltedPointsAlsoAcrossTheHorizon) {
  const RectLight light{{0.3f, -0.2f, 2}, {0.1f, 0.5f, 0.1f}, {0.7f, 0, -0.2f}, {}};
  for (const Vec3d& normal : {Vec3d{0, 0, 1}, Vec3d{1, 0, 0}, Vec3d{0.6, 0.64, 0.48},
                              Vec3d{0, -0.8, -0.6}, Vec3d{-0.96, 0, -0.28}}) {
    const Vec3d point{0.4, 0.3, 0.2};
    EXPECT_NEAR(RectangleFormFactor(light, point, normal), Integrated(light, point, normal), 1e-4);
  }
}

TEST(FormFactor, ATinyDistanceFillsTheHemisphere) {
  EXPECT_NEAR(RectangleFormFactor(Ceiling(1, 1, 1), {0, 0, 0.9999}, {0, 0, 1}), M_PI, 1e-3);
}

TEST(FormFactor, NoLightBehindTheLightOrBelowTheHorizon) {
  EXPECT_EQ(RectangleFormFactor(Ceiling(1, 1, 1), {0, 0, 2}, {0, 0, -1}), 0);
  EXPECT_EQ(RectangleFormFactor(Ceiling(1, 1, 1), {0, 0, 0}, {0, 0, -1}), 0);
  EXPECT_EQ(RectangleFormFactor(Ceiling(1, 1, 1), {0.2, 0.1, 1}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace silt::sim
