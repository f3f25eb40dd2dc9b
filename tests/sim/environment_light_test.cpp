// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/environment_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene_builder.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Gray all round but for a bright texel overhead.
Scene UnderASun() {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  Image<Vec3f> sky(64, 32, {0.5f, 0.5f, 0.5f});
  sky(16, 8) = {400, 0, 0};
  builder.scene.environment = std::make_shared<const Environment>(sky);
  return builder.scene;
}

TEST(EnvironmentLight, AnEvenSkyGivesPiTimesItsRadiance) {
  Scene scene;
  scene.environment = std::make_shared<const Environment>(Image<Vec3f>(8, 4, {0.5f, 1, 2}));
  const RayTracer tracer(scene);
  const EnvironmentLight light(scene, tracer, 1024);
  const Vec3f e = light.Irradiance({}, Normalized(Vec3f{0.5f, 0.2f, 0.8f}));
  EXPECT_NEAR(e.x / (kPi / 2), 1, 0.01);
  EXPECT_NEAR(e.z / (kPi * 2), 1, 0.01);
}

TEST(EnvironmentLight, ASunStandsOutAndCastsAShadow) {
  const Scene scene = UnderASun();
  const RayTracer tracer(scene);
  const EnvironmentLight light(scene, tracer, 1024);
  const Vec3f open = light.Irradiance({5, 0, 0}, {0, 0, 1});
  // The texel's tent of bilinear weights holds as much as the texel itself.
  const double polar = kPi * 8.5 / 32;
  const double solid_angle = 2 * kPi / 64 * kPi / 32 * std::sin(polar);
  EXPECT_NEAR(open.x, 0.5 * kPi + 400 * solid_angle * std::cos(polar), 0.05 * open.x);
  EXPECT_NEAR(open.y, 0.5 * kPi, 0.1);
  // The sun stands in the west (−x); below the board east of it there is only sky.
  const Vec3f shaded = light.Irradiance({-0.5f, 0, -0.2f}, {0, 0, 1});
  EXPECT_LT(shaded.x, 0.5f * kPi);
}

TEST(EnvironmentLight, AConstantAmbientIsNotItsTask) {
  Scene scene;
  scene.ambient = {1, 1, 1};
  const RayTracer tracer(scene);
  EXPECT_EQ(EnvironmentLight(scene, tracer, 64).Irradiance({}, {0, 0, 1}).x, 0);
}

}  // namespace
}  // namespace silt::sim
