// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "silt/sim/form_factor.h"

namespace silt::sim {
namespace {

const RectLight kLight{{0.3f, -0.2f, 2}, {0.4f, 0.3f, 0}, {0.6f, -0.8f, 0}, {1, 1, 1}};

TEST(SphericalRectangle, ASideOfACubeIsASixthOfTheSphere) {
  const RectLight side{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  EXPECT_NEAR(SphericalRectangle(side, {}).solid_angle(), 4 * std::numbers::pi / 6, 1e-9);
  const RectLight flipped{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
  EXPECT_NEAR(SphericalRectangle(flipped, {}).solid_angle(), 4 * std::numbers::pi / 6, 1e-9);
}

TEST(SphericalRectangle, WaysEndOnTheRectangle) {
  const Vec3f eye{1, 0.5f, -0.3f};
  const SphericalRectangle seen(kLight, eye);
  for (float u = 0.01f; u < 1; u += 0.07f) {
    for (float v = 0.01f; v < 1; v += 0.07f) {
      const Vec3f off = eye + seen.WayTo({u, v}) - kLight.center;
      EXPECT_NEAR(off.z, 0, 1e-5f);
      EXPECT_LE(std::abs(Dot(off, kLight.half_u)), 1.0001f * Dot(kLight.half_u, kLight.half_u));
      EXPECT_LE(std::abs(Dot(off, kLight.half_v)), 1.0001f * Dot(kLight.half_v, kLight.half_v));
    }
  }
}

// Drawn evenly, directions have the mean cosine that the exact form factor tells: π·F = Ω·mean.
TEST(SphericalRectangle, DirectionsAreEvenlySpread) {
  for (const Vec3f& eye : {Vec3f{1, 0.5f, -0.3f}, Vec3f{-3, 2, 1.5f}, Vec3f{0.3f, -0.2f, 1.9f}}) {
    const SphericalRectangle seen(kLight, eye);
    constexpr int n = 200;
    double cosines = 0;
    for (int i = 0; i < n * n; ++i) {
      const Vec3f way =
          seen.WayTo({(float(i % n) + 0.5f) / float(n), (float(i / n) + 0.5f) / float(n)});
      cosines += double(way.z / Norm(way)) / (n * n);
    }
    // In radiance times form factor, π is in the factor.
    const double factor = RectangleFormFactor(kLight, eye.Cast<double>(), {0, 0, 1});
    EXPECT_NEAR(seen.solid_angle() * cosines, factor, 1e-4 * factor);
  }
}

TEST(SphericalRectangle, EdgeOnOrFarAwayItHasNoSolidAngle) {
  EXPECT_EQ(SphericalRectangle(kLight, {5, 5, 2}).solid_angle(), 0);
  EXPECT_EQ(SphericalRectangle(kLight, {0, 0, 1e4f}).solid_angle(), 0);
}

TEST(SphericalRectangle, SidesMustBeAtRightAngles) {
  EXPECT_TRUE(SphericalRectangle::IsPossible(kLight));
  EXPECT_FALSE(SphericalRectangle::IsPossible({{}, {1, 0, 0}, {0.1f, 1, 0}, {1, 1, 1}}));
}

}  // namespace
}  // namespace silt::sim
