// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "scene_builder.h"
#include "silt/core/random.h"
#include "silt/sim/ggx.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Estimate {
  double mean = 0, error = 0;  // standard error
};

using RayOf = std::function<RayPacket::Segment(int i)>;

// Of the red radiance along ray i of n, one path each, all independent.
Estimate Trace(const Scene& scene, const PathOptions& options, int n, const RayOf& ray_of) {
  const RayTracer rays(scene);
  const PathTracer tracer(scene, rays, options);
  double sum = 0, squares = 0;
  for (int first = 0; first < n; first += kPacketSize) {
    RayPacket packet;
    PathSampler samplers[kPacketSize];
    for (int i = 0; i < kPacketSize; ++i) {
      packet.Set(i, ray_of(first + i));
      samplers[i] = PathSampler(std::uint64_t(first + i), 0);
    }
    Vec3f radiance[kPacketSize];
    tracer.Trace(packet, samplers, radiance);
    for (const Vec3f& r : radiance) {
      sum += r.x / n;
      squares += double(r.x) * r.x / n;
    }
  }
  return {sum, std::sqrt((squares - sum * sum) / n)};
}

Estimate Trace(const Scene& scene, const PathOptions& options, int n,
               const RayPacket::Segment& ray) {
  return Trace(scene, options, n, [&](int) { return ray; });
}

void ExpectEqual(const Estimate& a, const Estimate& b) {
  EXPECT_NEAR(a.mean, b.mean, 4 * std::hypot(a.error, b.error)) << a.error << ' ' << b.error;
}

Material Mirror() {
  Material mirror;
  mirror.diffuse = {1, 1, 1};
  mirror.mirror = true;
  return mirror;
}

Scene Furnace(const Material& material) {
  SceneBuilder builder;
  const int m = builder.AddMaterial(material);
  builder.AddQuad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  builder.AddQuad({-2, 1, 0}, {4, 0, 0}, {0, 0, 2}, m);
  builder.AddBox({-0.9f, 0.2f, 0}, {-0.3f, 0.8f, 0.9f}, m);
  builder.AddSphere({0.6f, 0.3f, 0.4f}, 0.4f, 24, m);
  builder.scene.ambient = {1, 1, 1};
  return builder.scene;
}

// From in front of the furnace, fanned over all that is in it.
RayPacket::Segment FurnaceRay(int i) {
  const CounterRandom random(9);
  const auto k = std::uint64_t(2 * i);
  return {{0, -4, 1},
          {float(random.Uniform(k)) - 0.5f, 2.0f, -0.55f * float(random.Uniform(k + 1))}};
}

// Whatever reflects all light looks like the white sky about it: 0.5 %.
TEST(PathTracer, AWhiteFurnaceIsWhite) {
  Material white;
  white.diffuse = {1, 1, 1};
  Material varnished = white;
  varnished.specular = 0.04f;
  varnished.roughness = 0.4f;
  for (const Material& material : {white, Mirror(), varnished}) {
    EXPECT_NEAR(Trace(Furnace(material), {}, 4096, FurnaceRay).mean, 1, 5e-3);
  }
}

TEST(PathTracer, AGrayPlateReflectsItsAlbedoOfTheSky) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0.25f, 0}));
  builder.scene.ambient = {2, 2, 2};
  const Estimate red = Trace(builder.scene, {}, 1024, {{0, 0, 1}, {0.1f, 0, -1}});
  EXPECT_NEAR(red.mean, 1, 1e-5);
}

TEST(PathTracer, AMetalPlateReflectsGgxsIntegratedAlbedo) {
  Material metal;
  metal.diffuse = {0.8f, 0.8f, 0.8f};
  metal.metallic = 1;
  metal.roughness = 0.6f;
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(metal));
  builder.scene.ambient = {1, 1, 1};
  const Estimate e = Trace(builder.scene, {}, 100'000, {{0.5f, 0, 1}, {-0.5f, 0, -1}});
  const float cosine = 1 / std::sqrt(1.25f);
  EXPECT_NEAR(e.mean / DirectionalAlbedo(cosine, 0.36f).Of({0.8f, 0, 0}).x, 1, 5e-3);
  // Seen as matt where reflection is off.
  PathOptions matt;
  matt.reflection = false;
  EXPECT_NEAR(Trace(builder.scene, matt, 64, {{0.5f, 0, 1}, {-0.5f, 0, -1}}).mean, 0.8, 1e-5);
}

// A unit square that shines, and another (white) whose mean radiance is then the form factor
// between them: seen from just above, at random places.
double FormFactor(const Vec3f& corner, const Vec3f& u, const Vec3f& v, LightStrategy strategy) {
  SceneBuilder builder;
  const int white = builder.AddMaterial(Vec3f{1, 1, 1});
  const int lamp = builder.AddMaterial(Vec3f{}, {1, 1, 1});
  builder.AddQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, white);
  builder.AddQuad(corner, u, v, lamp);
  PathOptions options;
  options.strategy = strategy;
  const CounterRandom random(3);
  return Trace(builder.scene, options, 200'000,
               [&](int i) {
                 const auto k = std::uint64_t(2 * i);
                 const Vec3f at{float(random.Uniform(k)), float(random.Uniform(k + 1)), 1e-3f};
                 return RayPacket::Segment{at, {0, 0, -1}};
               })
      .mean;
}

// 200 000 paths: 1 %.
TEST(PathTracer, ParallelSquaresHaveTheirFormFactor) {
  const double expected = 0.199825;  // unit squares at distance 1
  for (const LightStrategy s : {LightStrategy::kBoth, LightStrategy::kAim, LightStrategy::kMeet}) {
    EXPECT_NEAR(FormFactor({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, s) / expected, 1, 0.01);
  }
}

TEST(PathTracer, PerpendicularSquaresHaveTheirFormFactor) {
  const double expected = 0.200044;  // unit squares with a common edge
  const LightStrategy s = LightStrategy::kBoth;
  EXPECT_NEAR(FormFactor({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, s) / expected, 1, 0.01);
}

// E = π L (R/d)² on a surface that faces a sphere: 1 % at 20 000 paths.
TEST(PathTracer, ASphereLightsByItsSolidAngle) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0, 0}));
  builder.AddSphere({0, 0, 2}, 0.5f, 96, builder.AddMaterial(Vec3f{}, {3, 3, 3}));
  const Estimate e = Trace(builder.scene, {}, 20'000, {{0, 0, 0.1f}, {0, 0, -1}});
  EXPECT_NEAR(e.mean / (0.5 * 3 * 0.25 * 0.25), 1, 0.01);
}

// All that paths meet: two kinds of light, several bounces, a coat, a mirror.
Scene MixedRoom() {
  Scene scene = RoomWithBoxAndBall();
  scene.ambient = {};
  scene.materials[0].specular = 0.3f;
  scene.materials[0].roughness = 0.5f;
  scene.materials[2] = Mirror();
  scene.materials[2].diffuse = {0.9f, 0.9f, 0.9f};
  Image<Vec3f> sky(8, 4, {0.2f, 0.2f, 0.2f});
  sky(1, 1) = {9, 9, 9};
  scene.environment = std::make_shared<const Environment>(sky);
  return scene;
}

constexpr RayPacket::Segment kAtTheFloor{{0, -1.5f, 1.2f}, {0.1f, 1, -0.7f}};

TEST(PathTracer, BothStrategiesAgreeWithEachAlone) {
  const Scene scene = MixedRoom();
  PathOptions both, aim, meet;
  aim.strategy = LightStrategy::kAim;
  meet.strategy = LightStrategy::kMeet;
  const Estimate reference = Trace(scene, both, 60'000, kAtTheFloor);
  EXPECT_LT(reference.error, 0.02 * reference.mean);
  ExpectEqual(reference, Trace(scene, aim, 60'000, kAtTheFloor));
  const Estimate met = Trace(scene, meet, 120'000, kAtTheFloor);
  ExpectEqual(reference, met);
  EXPECT_LT(reference.error, met.error);
}

TEST(PathTracer, RouletteChangesNoMean) {
  const Scene scene = MixedRoom();
  PathOptions whole;
  whole.roulette = false;
  whole.most_bounces = 40;
  ExpectEqual(Trace(scene, {}, 40'000, kAtTheFloor), Trace(scene, whole, 20'000, kAtTheFloor));
}

// A board with a hole (alpha below ½ in its right half) under a lamp.
TEST(PathTracer, LightPassesThroughHoles) {
  SceneBuilder builder;
  Image<Rgba8> half(2, 1, {255, 255, 255, 255});
  half(1, 0).a = 0;
  builder.scene.textures.emplace_back(half);
  Material board;
  board.texture = 0;
  board.cutout = true;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0, 0}));
  builder.AddQuad({-1, -1, 0.2f}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(board));
  builder.AddLight({0, 0, 3}, {0, 0.05f, 0}, {0.05f, 0, 0}, {100, 0, 0});
  const auto floor_at = [&](float x) {
    return Trace(builder.scene, {}, 256, {{x, 0, 0.1f}, {0, 0, -1}}).mean;
  };
  const float lit = 0.5f / kPi * 100 * 0.01f / 9.0f;
  EXPECT_NEAR(floor_at(0.5f) / lit, 0.95, 0.05);  // cos⁴ of the slant
  EXPECT_LT(floor_at(-0.5f), 0.05 * lit);
}

TEST(PathTracer, TheBackOfAOneSidedMaterialIsBlack) {
  SceneBuilder builder;
  Material front_only;
  front_only.two_sided = false;
  front_only.emission = {1, 1, 1};
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(front_only));
  builder.scene.ambient = {1, 1, 1};
  EXPECT_GT(Trace(builder.scene, {}, 16, {{0, 0, 1}, {0, 0, -1}}).mean, 1);
  EXPECT_EQ(Trace(builder.scene, {}, 16, {{0, 0, -1}, {0, 0, 1}}).mean, 0);
}

TEST(PathTracer, KnownIrradianceEndsAPath) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{0.5f, 0, 0}));
  builder.scene.ambient = {7, 7, 7};
  PathOptions options;
  options.known_irradiance = [](const TriangleHit& hit) {
    return hit.front ? Vec3f{2 * kPi, 0, 0} : Vec3f{kPi, 0, 0};
  };
  EXPECT_NEAR(Trace(builder.scene, options, 16, {{0, 0, 1}, {0, 0, -1}}).mean, 1, 1e-6);
  EXPECT_NEAR(Trace(builder.scene, options, 16, {{0, 0, -1}, {0, 0, 1}}).mean, 0.5, 1e-6);
  // A mirror shows what stands before it.
  builder.scene.materials[0] = Mirror();
  EXPECT_NEAR(Trace(builder.scene, options, 16, {{0, 0, 1}, {0, 0, -1}}).mean, 7, 1e-6);
}

TEST(PathTracer, RaysNeedNotBeUnitAndMayMiss) {
  Scene scene;
  scene.ambient = {0.25f, 0, 0};
  EXPECT_NEAR(Trace(scene, {}, 16, {{0, 0, 0}, {0, 5, 0}}).mean, 0.25, 1e-6);
}

}  // namespace
}  // namespace silt::sim
