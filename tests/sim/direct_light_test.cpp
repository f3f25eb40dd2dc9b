// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/direct_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"
#include "silt/sim/form_factor.h"

namespace silt::sim {
namespace {

constexpr int kPoints = 16;

// A square metre of light 2 m above a floor, and half way a board that covers x < edge.
Scene FloorAndBoard(float edge) {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{1, 1, 1});
  builder.AddQuad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, white);
  builder.AddLight({0, 0, 2}, {0, 0.5f, 0}, {0.5f, 0, 0}, {3, 2, 1});
  if (edge > -5) builder.AddQuad({-5, -5, 1}, {5 + edge, 0, 0}, {0, 10, 0}, white);
  return builder.scene;
}

float RedAt(const Scene& scene, const Vec3f& position) {
  const RayTracer tracer(scene);
  return DirectLight(scene, tracer, kPoints).Irradiance(position, {0, 0, 1}).x;
}

TEST(DirectLight, IsRadianceTimesFormFactorWhereNothingIsInBetween) {
  const Scene scene = FloorAndBoard(-5);
  const RayTracer tracer(scene);
  const DirectLight direct(scene, tracer, kPoints);
  for (const Vec3f& point : {Vec3f{0, 0, 0}, Vec3f{1, 0.5f, 0}, Vec3f{-3, 2, 0}}) {
    const double factor = RectangleFormFactor(scene.lights[0], point.Cast<double>(), {0, 0, 1});
    const Vec3f irradiance = direct.Irradiance(point, {0, 0, 1});
    EXPECT_NEAR(irradiance.x, 3 * factor, 1e-5);
    EXPECT_NEAR(irradiance.y, 2 * factor, 1e-5);
    EXPECT_NEAR(irradiance.z, 1 * factor, 1e-5);
  }
}

TEST(DirectLight, ABoardCastsAShadowWithAPenumbra) {
  // The board's edge over x = 0: the light's edges throw it to x = ±0.5 on the floor.
  const Scene scene = FloorAndBoard(0);
  const Scene open = FloorAndBoard(-5);
  EXPECT_EQ(RedAt(scene, {-0.6f, 0, 0}), 0);
  EXPECT_FLOAT_EQ(RedAt(scene, {0.6f, 0, 0}), RedAt(open, {0.6f, 0, 0}));
  EXPECT_NEAR(RedAt(scene, {0, 0, 0}) / RedAt(open, {0, 0, 0}), 0.5, 0.01);
  float before = 0;
  for (float x = -0.6f; x < 0.6f; x += 0.05f) {
    const float share = RedAt(scene, {x, 0, 0}) / RedAt(open, {x, 0, 0});
    EXPECT_GE(share, before - 1e-6f) << x;
    EXPECT_LE(share, before + 0.2f) << x;
    before = share;
  }
}

TEST(DirectLight, PointsOnAGridOfAnyNumberAreAllUsed) {
  const Scene scene = FloorAndBoard(0);
  const RayTracer tracer(scene);
  for (const int points : {1, 2, 3, 7}) {
    const float red = DirectLight(scene, tracer, points).Irradiance({0.6f, 0, 0}, {0, 0, 1}).x;
    EXPECT_FLOAT_EQ(red, RedAt(scene, {0.6f, 0, 0})) << points;
  }
}

// In steps of a 32nd of the light's width where its edge passes.
TEST(DirectLight, PenumbrasAreLookedAtMoreClosely) {
  const Scene scene = FloorAndBoard(0);
  const RayTracer tracer(scene);
  const DirectLight direct(scene, tracer, 16);
  const float open = RedAt(FloorAndBoard(-5), {0, 0, 0});
  for (float x = -0.3f; x <= 0.3f; x += 0.05f) {
    const float share = direct.Irradiance({x, 0, 0}, {0, 0, 1}).x / open;
    const float exact = 0.5f + x;  // of an evenly bright light; the cosines bend it a little
    EXPECT_NEAR(share, exact, 0.05f) << x;
  }
}

// A lamp in a case whose rim stands 2 cm in front of it and hides up to 2 % of it: less than lies
// between points of the grid.
TEST(DirectLight, RimsHideWhatTheyCover) {
  SceneBuilder builder;
  const int black = builder.AddMaterial(Vec3f{});
  builder.AddLight({0, 0, 2}, {0, 0.5f, 0}, {0.5f, 0, 0}, {3, 2, 1});
  const Scene open = builder.scene;
  for (const float side : {-1.0f, 1.0f}) {
    builder.AddQuad({side * 0.5f, -0.6f, 1.98f}, {0, 1.2f, 0}, {0, 0, 0.03f}, black);
    builder.AddQuad({-0.6f, side * 0.5f, 1.98f}, {1.2f, 0, 0}, {0, 0, 0.03f}, black);
  }
  const RayTracer tracer(builder.scene);
  for (const float x : {0.0f, 1.0f, 2.0f}) {
    // From x, the rim at x = ½ hides the strip beyond ½ − (x − ½)/99: by cos θ cos θ' / r² ∝ r⁻⁴.
    double hidden = 0, all = 0;
    for (double s = -0.4995; s < 0.5; s += 0.001) {
      for (double t = -0.49; t < 0.5; t += 0.02) {
        const double weight = std::pow((s - x) * (s - x) + t * t + 4, -2);
        all += weight;
        if (s > 0.5 - (x - 0.5) / 99) hidden += weight;
      }
    }
    const float red = DirectLight(builder.scene, tracer, 8).Irradiance({x, 0, 0}, {0, 0, 1}).x;
    EXPECT_NEAR(red / RedAt(open, {x, 0, 0}), 1 - hidden / all, 0.004) << x;
  }
}

TEST(DirectLight, DoesNotShineBackwardsOrThroughTheFloor) {
  const Scene scene = FloorAndBoard(-5);
  const RayTracer tracer(scene);
  const DirectLight direct(scene, tracer, kPoints);
  EXPECT_EQ(direct.Irradiance({0, 0, 3}, {0, 0, -1}).x, 0);
  EXPECT_EQ(direct.Irradiance({0, 0, -0.01f}, {0, 0, 1}).x, 0);
  EXPECT_EQ(direct.Irradiance({0, 0, 0}, {0, 0, -1}).x, 0);
}

}  // namespace
}  // namespace silt::sim
