// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_builder.h"
#include "silt/core/parallel.h"
#include "silt/core/random.h"
#include "silt/sim/form_factor.h"
#include "silt/sim/indirect_light.h"
#include "silt/sim/irradiance.h"
#include "silt/sim/path_tracer.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

// Enough for a room of plain walls.
LightingOptions Coarser() {
  LightingOptions options;
  options.direct_spacing_m = 0.05f;
  options.indirect_spacing_m = 0.2f;
  return options;
}

// Of what paths bring along 16 rays, so many times.
Vec3f MeanRadiance(const PathTracer& paths, const RayPacket& rays, int packets) {
  Vec3f sum;
  for (int k = 0; k < packets; ++k) {
    PathSampler samplers[kPacketSize];
    for (int i = 0; i < kPacketSize; ++i) {
      samplers[i] = PathSampler(1, std::uint32_t(k * kPacketSize + i));
    }
    Vec3f radiance[kPacketSize];
    paths.Trace(rays, samplers, radiance);
    for (const Vec3f& r : radiance) sum += (1.0f / float(packets * kPacketSize)) * r;
  }
  return sum;
}

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

// A closed box of albedo ρ whose every side sends M by itself: all reflections together give
// E = π M / (1 − ρ), everywhere within.
TEST(LightSolver, AFurnaceGathersAllReflections) {
  SceneBuilder builder;
  builder.AddBox({-1, -1, -1}, {1, 1, 1},
                 builder.AddMaterial(Vec3f{0.7f, 0.5f, 0}, Vec3f{1, 2, 3}));
  builder.scene.ambient = {100, 100, 100};  // outside
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, Coarser());
  for (const std::uint32_t triangle : {0u, 3u, 7u, 11u}) {
    const Vec3f e = irradiance.At(triangle, 0.4f, 0.2f, false);
    EXPECT_NEAR(e.x / (kPi / 0.3f), 1, 0.01);
    EXPECT_NEAR(e.y / (2 * kPi / 0.5f), 1, 0.01);
    EXPECT_NEAR(e.z / (3 * kPi), 1, 0.005);
  }
}

// The baked light of a room is that of the path tracer: a mirrorless room, points all over it.
TEST(LightSolver, AgreesWithThePathTracer) {
  const Scene scene = RoomWithBoxAndBall();
  const RayTracer tracer(scene);
  const Irradiance irradiance(scene, tracer, Coarser());
  const PathTracer paths(scene, tracer);
  const std::vector<Vec3f> rays{{0, 1, -0.4f},   {0.5f, 1, -0.3f}, {-0.9f, 1, -0.3f},
                                {0.3f, 1, 0.2f}, {0.9f, 1, 0.4f},  {-0.3f, 1, -0.45f}};
  for (const Vec3f& direction : rays) {
    RayPacket packet;
    for (int i = 0; i < kPacketSize; ++i) packet.Set(i, {{0, -1.9f, 1.2f}, direction});
    HitPacket hits;
    tracer.Trace(packet, hits);
    const Vec3f albedo = scene.materials[scene.mesh.triangles[hits.triangle[0]].material].diffuse;
    const Vec3f e = irradiance.At(hits.triangle[0], hits.u[0], hits.v[0], hits.cosine[0] < 0);
    const Vec3f traced = MeanRadiance(paths, packet, 128);
    EXPECT_NEAR(albedo.x * e.x / kPi / traced.x, 1, 0.03) << direction.x << ' ' << direction.z;
  }
}

// The floor under a box that stands on it is dark, but no shadow of it leaks out.
TEST(LightSolver, WhatIsBuriedDarkensNothingThatIsSeen) {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{0, 0, 0});
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, white);
  builder.scene.ambient = {1, 1, 1};
  const Scene open = builder.scene;
  builder.AddBox({-0.41f, -0.41f, 0}, {0.41f, 0.41f, 0.002f}, white);  // flat: casts no shadow
  const auto at = [](const Scene& scene, float x) {
    const RayTracer tracer(scene);
    return Irradiance(scene, tracer, {}).At(0, (1 + x) / 2 - 0.5f, 0.5f, true).x;
  };
  EXPECT_NEAR(at(builder.scene, 0.42f), at(open, 0.42f), 0.03f);
}

// A board 2 cm above a floor, under an even sky: light is shared less and less widely towards it.
TEST(LightSolver, ABoardCloseByLeavesNoStripeBesideIt) {
  SceneBuilder builder;
  const int black = builder.AddMaterial(Vec3f{});
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, black);
  builder.AddBox({-0.5f, -0.5f, 0.02f}, {0, 0.5f, 0.03f}, black);
  builder.scene.ambient = {1, 1, 1};
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, {});
  const IndirectLight exact(builder.scene, tracer, 1 << 14, 0);
  for (const float x : {0.025f, 0.05f, 0.075f, 0.1f, 0.15f, 0.2f}) {
    const float expected =
        exact.Gather({x, 0.01f, 0}, {0, 0, 1}, 0, [](auto&&...) { return Vec3f{}; }).irradiance.x;
    const float stored = irradiance.At(0, (1 + x) / 2 - 0.505f, 0.505f, true).x;
    EXPECT_NEAR(stored / expected, 1, 0.05f) << x;
  }
}

// A post on a floor, much smaller than the areas that share light in the open, from 2 cm away:
// nearer, samples stand too far apart.
TEST(LightSolver, DarkensTheFloorBesideAPost) {
  SceneBuilder builder;
  const int black = builder.AddMaterial(Vec3f{});
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, black);
  builder.AddBox({0.1f, 0.1f, 0}, {0.13f, 0.13f, 0.2f}, black);
  builder.scene.ambient = {1, 1, 1};
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, {});
  const IndirectLight exact(builder.scene, tracer, 1 << 14, 0);
  for (const float x : {0.15f, 0.16f, 0.18f}) {
    const float expected =
        exact.Gather({x, 0.115f, 0}, {0, 0, 1}, 0, [](auto&&...) { return Vec3f{}; }).irradiance.x;
    // Triangle 0 holds the points with x > y: u grows with x − y, v with y.
    const float stored = irradiance.At(0, (x - 0.115f) / 2, (1 + 0.115f) / 2, true).x;
    EXPECT_NEAR(stored / expected, 1, 0.05f) << x;
  }
}

// Black tiles lie on a white floor, most of whose samples they hide: what is reflected between them
// is that of the strips that are seen.
TEST(LightSolver, StripsBetweenTilesReflectAllTheirLight) {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{0.8f, 0.8f, 0.8f}),
            black = builder.AddMaterial(Vec3f{});
  builder.AddQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, white);
  for (int i = 0; i < 14; ++i) {
    const float x = 0.07f * float(i) + 0.013f;
    builder.AddBox({x, 0.01f, 0}, {x + 0.05f, 0.99f, 0.002f}, black);
  }
  const auto ceiling = std::uint32_t(builder.scene.mesh.triangles.size());
  builder.AddQuad({0, 0, 0.5f}, {0, 1, 0}, {1, 0, 0}, white);
  builder.AddLight({0.5f, 0.5f, 0.49f}, {0, 0.1f, 0}, {0.1f, 0, 0}, {5, 5, 5});
  const RayTracer tracer(builder.scene);
  const Irradiance irradiance(builder.scene, tracer, {});
  const PathTracer paths(builder.scene, tracer);
  RayPacket packet;
  for (int i = 0; i < kPacketSize; ++i) packet.Set(i, {{0.2f, 0.3f, 0.35f}, {0, 0, 1}});
  const float traced = MeanRadiance(paths, packet, 512).x;
  const float stored = irradiance.At(ceiling, 0.1f, 0.2f, true).x;
  EXPECT_NEAR(0.8f * stored / kPi / traced, 1, 0.04);
}

// Corners of tiles, where samples come first, hold a peg each and are dark; the tiles are not.
TEST(LightSolver, DarkCornersDoNotStandForWhatLiesBetweenThem) {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{0.8f, 0.8f, 0.8f});
  for (int i = 0; i < 100; ++i) {
    const Vec3f corner{0.1f * float(i % 10), 0.1f * float(i / 10), 0};
    builder.AddQuad(corner, {0.1f, 0, 0}, {0, 0.1f, 0}, white);
    builder.AddBox(corner - Vec3f{0.015f, 0.015f, 0.001f}, corner + Vec3f{0.015f, 0.015f, 0.03f},
                   white);
  }
  const auto first_wall = std::uint32_t(builder.scene.mesh.triangles.size());
  builder.AddQuad({0, 0, 0.4f}, {0, 1, 0}, {1, 0, 0}, white);
  builder.AddQuad({0, 0, 0}, {0, 1, 0}, {0, 0, 0.4f}, white);
  builder.AddQuad({1, 0, 0}, {0, 0, 0.4f}, {0, 1, 0}, white);
  builder.AddQuad({0, 0, 0}, {0, 0, 0.4f}, {1, 0, 0}, white);
  builder.AddQuad({0, 1, 0}, {1, 0, 0}, {0, 0, 0.4f}, white);
  builder.AddLight({0.5f, 0.5f, 0.39f}, {0, 0.1f, 0}, {0.1f, 0, 0}, {5, 5, 5});
  const RayTracer tracer(builder.scene);
  LightingOptions options;
  options.direct_spacing_m = 0.0125f;
  const Irradiance irradiance(builder.scene, tracer, options);
  const PathTracer paths(builder.scene, tracer);
  for (const float x : {0.2f, 0.8f}) {
    RayPacket packet;
    for (int i = 0; i < kPacketSize; ++i) packet.Set(i, {{x, 0.3f, 0.35f}, {0, 0, 1}});
    const float traced = MeanRadiance(paths, packet, 512).x;
    // The ceiling's triangles: u along y and v along x, split by its diagonal.
    const float stored = x < 0.3f ? irradiance.At(first_wall, 0.3f - x, x, true).x
                                  : irradiance.At(first_wall + 1, 0.3f, x - 0.3f, true).x;
    EXPECT_NEAR(0.8f * stored / kPi / traced, 1, 0.02) << x;
  }
}

TEST(LightSolver, SeedsDifferByLittle) {
  const Scene scene = RoomWithBoxAndBall();
  const RayTracer tracer(scene);
  LightingOptions other = Coarser();
  other.seed = 1;
  const Irradiance a(scene, tracer, Coarser()), b(scene, tracer, other);
  double sum = 0, squares = 0;
  const CounterRandom random(3);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto triangle =
        std::uint32_t(random.Uniform(3 * i) * double(scene.mesh.triangles.size() - 2));
    const auto u = float(random.Uniform(3 * i + 1) / 2), v = float(random.Uniform(3 * i + 2) / 2);
    const float first = a.At(triangle, u, v, true).y, second = b.At(triangle, u, v, true).y;
    sum += first / 2000;
    squares += double(first - second) * (first - second) / 2000;
  }
  EXPECT_GT(squares, 0);
  EXPECT_LT(std::sqrt(squares), 0.015 * sum);
}

TEST(LightSolver, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = RoomWithBoxAndBall();
  const RayTracer tracer(scene);
  const SurfaceGrid grid(scene.mesh, 0.2f);
  BakedLight light[2];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    light[threads - 1] = SolveLight(scene, tracer, grid, {});
  }
  SetThreadCount(0);
  for (std::size_t i = 0; i < grid.samples().size(); ++i) {
    EXPECT_EQ(light[0].samples.front[i].x, light[1].samples.front[i].x);
    EXPECT_EQ(light[0].samples.back[i].z, light[1].samples.back[i].z);
  }
  EXPECT_FALSE(light[0].fine.patches().empty());
  EXPECT_EQ(light[0].fine.patches(), light[1].fine.patches());
  for (std::size_t i = 0; i < light[0].fine.irradiance().size(); ++i) {
    EXPECT_EQ(light[0].fine.irradiance()[i].y, light[1].fine.irradiance()[i].y);
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

}  // namespace
}  // namespace silt::sim
