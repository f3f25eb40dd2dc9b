// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_solver.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene_builder.h"
#include "silt/core/parallel.h"
#include "silt/core/random.h"
#include "silt/sim/form_factor.h"
#include "silt/sim/irradiance.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

Scene LampOverFloor(const Vec3f& ambient) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f}));
  builder.AddLight({0.2f, 0.1f, 1.5f}, {0, 0.3f, 0}, {0.4f, 0, 0}, {4, 5, 6});
  builder.scene.ambient = ambient;
  return builder.scene;
}

// Between the samples too: 1 % of the exact form factor.
TEST(LightSolver, AFloorUnderALampHasItsFormFactor) {
  const Scene scene = LampOverFloor({});
  const RayTracer tracer(scene);
  const Irradiance irradiance(scene, tracer, {});
  const CounterRandom random(7);
  for (std::uint64_t i = 0; i < 500; ++i) {
    float u = float(random.Uniform(2 * i)), v = float(random.Uniform(2 * i + 1));
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto triangle = std::uint32_t(i % 2);
    const std::uint32_t* vertex = scene.mesh.triangles[triangle].vertex;
    const std::vector<Vec3f>& p = scene.mesh.positions;
    const Vec3f point = (1 - u - v) * p[vertex[0]] + u * p[vertex[1]] + v * p[vertex[2]];
    const double factor = RectangleFormFactor(scene.lights[0], point.Cast<double>(), {0, 0, 1});
    EXPECT_NEAR(irradiance.At(triangle, u, v, true).x / (4 * factor), 1, 0.01);
    EXPECT_NEAR(irradiance.At(triangle, u, v, true).z / (6 * factor), 1, 0.01);
    EXPECT_EQ(irradiance.At(triangle, u, v, false).x, 0);
  }
}

TEST(LightSolver, AmbientReachesBothSidesOfAnOpenFloor) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f}));
  builder.scene.ambient = {0.5f, 0.25f, 1};
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, {});
  for (const bool front : {true, false}) {
    EXPECT_NEAR(irradiance.At(0, 0.3f, 0.3f, front).x, kPi / 2, 1e-4f);
    EXPECT_NEAR(irradiance.At(1, 0.2f, 0.5f, front).z, kPi, 1e-4f);
  }
}

// Deep between two large parallel plates, the lower lit by nothing but the upper's reflection:
// E = π·albedo·ambient, since the ambient stands for what the upper one receives.
TEST(LightSolver, OneReflectionCarriesTheAlbedo) {
  SceneBuilder builder;
  const int gray = builder.AddMaterial(Vec3f{0.6f, 0.3f, 0});
  builder.AddQuad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, gray);
  builder.AddQuad({-9, -9, 0.1f}, {0, 18, 0}, {18, 0, 0}, gray);
  builder.scene.ambient = {1, 1, 1};
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 0.5f;
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, options);
  const Vec3f e = irradiance.At(0, 0, 0.5f, true);  // the middle
  EXPECT_NEAR(e.x, 0.6f * kPi, 0.02f);
  EXPECT_NEAR(e.y, 0.3f * kPi, 0.02f);
  EXPECT_NEAR(e.z, 0, 0.02f);
}

TEST(LightSolver, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = RoomWithBoxAndBall();
  const RayTracer tracer(scene);
  const SurfaceGrid grid(scene.mesh, 0.2f);
  StoredLight light[2];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    light[threads - 1] = SolveLight(scene, tracer, grid, {});
  }
  SetThreadCount(0);
  for (std::size_t i = 0; i < grid.samples().size(); ++i) {
    EXPECT_EQ(light[0].front[i].x, light[1].front[i].x);
    EXPECT_EQ(light[0].back[i].z, light[1].back[i].z);
  }
}

TEST(LightSolver, ReportsProgressUpToTheEnd) {
  const Scene scene = LampOverFloor({1, 1, 1});
  const RayTracer tracer(scene);
  LightingOptions options;
  double last = 0;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  SolveLight(scene, tracer, SurfaceGrid(scene.mesh, 0.1f), options);
  EXPECT_DOUBLE_EQ(last, 1);
}

TEST(LightSolver, MeanAlbedoIsTheLinearMeanOfTheTexture) {
  SceneBuilder builder;
  Image<Rgba8> checkers(2, 2, {255, 255, 255, 255});
  checkers(0, 0) = checkers(1, 1) = {0, 0, 0, 255};
  builder.scene.textures.emplace_back(checkers);
  Material material;
  material.diffuse = {1, 0.5f, 0};
  material.texture = 0;
  builder.AddMaterial(material);
  const Vec3f albedo = MeanAlbedos(builder.scene)[0];
  EXPECT_NEAR(albedo.x, 0.5f, 3e-3f);  // mip levels are kept in 8 bits
  EXPECT_NEAR(albedo.y, 0.25f, 3e-3f);
}

}  // namespace
}  // namespace silt::sim
