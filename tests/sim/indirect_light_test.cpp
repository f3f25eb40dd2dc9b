// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/indirect_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene_builder.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kDirections = 256;

Vec3f Black(std::uint32_t, float, float, bool) { return {}; }

TEST(IndirectLight, OpenSkyGivesPiTimesItsRadiance) {
  Scene scene;
  scene.ambient = {0.5f, 1, 2};
  const RayTracer tracer(scene);
  const Vec3f e =
      IndirectLight(scene, tracer, kDirections).Irradiance({1, 2, 3}, {0.6f, 0, 0.8f}, Black);
  EXPECT_NEAR(e.x, kPi / 2, 1e-5f);
  EXPECT_NEAR(e.y, kPi, 1e-5f);
  EXPECT_NEAR(e.z, 2 * kPi, 1e-5f);
}

// A point at the foot of an endless black wall sees one half of the sky.
TEST(IndirectLight, AWallTakesHalfOfTheSky) {
  SceneBuilder builder;
  builder.AddQuad({0, -500, 0}, {0, 1000, 0}, {0, 0, 500}, builder.AddMaterial(Vec3f{}));
  builder.scene.ambient = {1, 1, 1};
  const RayTracer tracer(builder.scene);
  const IndirectLight light(builder.scene, tracer, kDirections);
  EXPECT_NEAR(light.Irradiance({0.01f, 0, 0}, {0, 0, 1}, Black).x, kPi / 2, 0.03f);
}

// Inside a closed box only what its sides radiate counts, and each ray asks for the side it meets.
TEST(IndirectLight, SurfacesRadiateByTriangleAndSide) {
  SceneBuilder builder;
  builder.AddBox({-1, -1, -1}, {1, 1, 1}, builder.AddMaterial(Vec3f{1, 1, 1}));
  builder.scene.ambient = {100, 100, 100};
  const RayTracer tracer(builder.scene);
  const IndirectLight light(builder.scene, tracer, kDirections);
  const auto inside = [](std::uint32_t, float u, float v, bool front) {
    EXPECT_GE(u, 0);
    EXPECT_LE(u + v, 1 + 1e-5f);
    return front ? Vec3f{} : Vec3f{0.25f, 0, 0};
  };
  EXPECT_NEAR(light.Irradiance({0, 0, 0}, {0, 0, 1}, inside).x, kPi / 4, 1e-5f);
  // The top (triangles 2 and 3) alone, from its centre's distance: F of a 2 × 2 square at 1.
  const auto top = [](std::uint32_t triangle, float, float, bool) {
    return triangle / 2 == 1 ? Vec3f{1, 0, 0} : Vec3f{};
  };
  EXPECT_NEAR(light.Irradiance({0, 0, 0}, {0, 0, 1}, top).x, 0.5541f * kPi, 0.03f);
}

}  // namespace
}  // namespace silt::sim
