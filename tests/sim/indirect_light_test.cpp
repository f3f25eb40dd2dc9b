// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/indirect_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_builder.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kDirections = 256;

Vec3f Black(const TriangleHit&, const Vec3f&) { return {}; }

TEST(IndirectLight, OpenSkyGivesPiTimesItsRadiance) {
  Scene scene;
  scene.ambient = {0.5f, 1, 2};
  const RayTracer tracer(scene);
  const Vec3f e = IndirectLight(scene, tracer, kDirections, 1)
                      .Gather({1, 2, 3}, {0.6f, 0, 0.8f}, 5, Black)
                      .irradiance;
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
  const IndirectLight light(builder.scene, tracer, kDirections, 1);
  EXPECT_NEAR(light.Gather({0.01f, 0, 0}, {0, 0, 1}, 0, Black).irradiance.x, kPi / 2, 0.03f);
}

// Inside a closed box only what its sides radiate counts, and each ray asks for the side it meets.
TEST(IndirectLight, SurfacesRadiateByTriangleAndSide) {
  SceneBuilder builder;
  builder.AddBox({-1, -1, -1}, {1, 1, 1}, builder.AddMaterial(Vec3f{1, 1, 1}));
  builder.scene.ambient = {100, 100, 100};
  const RayTracer tracer(builder.scene);
  const IndirectLight light(builder.scene, tracer, kDirections, 1);
  const auto inside = [](const TriangleHit& hit, const Vec3f& direction) {
    EXPECT_GE(hit.u, 0);
    EXPECT_LE(hit.u + hit.v, 1 + 1e-5f);
    EXPECT_NEAR(Norm(direction), 1, 1e-5f);
    return hit.front ? Vec3f{} : Vec3f{0.25f, 0, 0};
  };
  EXPECT_NEAR(light.Gather({0, 0, 0}, {0, 0, 1}, 0, inside).irradiance.x, kPi / 4, 1e-5f);
  // The top (triangles 2 and 3) alone, from its centre's distance: F of a 2 × 2 square at 1.
  const auto top = [](const TriangleHit& hit, const Vec3f&) {
    return hit.triangle / 2 == 1 ? Vec3f{1, 0, 0} : Vec3f{};
  };
  EXPECT_NEAR(light.Gather({0, 0, 0}, {0, 0, 1}, 0, top).irradiance.x, 0.5541f * kPi, 0.03f);
}

// A closed box is seen from within by its backs alone; a crack is too narrow to look into.
TEST(IndirectLight, KnowsWhatIsBuried) {
  SceneBuilder builder;
  builder.AddBox({-1, -1, -1}, {1, 1, 1}, builder.AddMaterial(Vec3f{1, 1, 1}));
  builder.AddQuad({-1, -1, 1.003f}, {2, 0, 0}, {0, 2, 0}, 0);
  const RayTracer tracer(builder.scene);
  const IndirectLight light(builder.scene, tracer, kDirections, 1);
  const auto gather = [&](const Vec3f& position, const Vec3f& normal) {
    return light.Gather(position, normal, 0, Black);
  };
  EXPECT_TRUE(gather({0, 0, 0}, {0, 0, 1}).buried);
  EXPECT_TRUE(gather({0, 0, 1}, {0, 0, 1}).buried);
  EXPECT_FALSE(gather({0, 0, 1.003f}, {0, 0, 1}).buried);
  EXPECT_FALSE(gather({1, 0, 0}, {1, 0, 0}).buried);
}

// Between two plates at distance h: the mean of cos θ / h with density cos θ / π is 2/(3h).
TEST(IndirectLight, DistanceIsTheHarmonicMean) {
  SceneBuilder builder;
  builder.AddQuad({-500, -500, 0.5f}, {0, 1000, 0}, {1000, 0, 0},
                  builder.AddMaterial(Vec3f{1, 1, 1}));
  const RayTracer tracer(builder.scene);
  const IndirectLight light(builder.scene, tracer, kDirections, 1);
  EXPECT_NEAR(light.Gather({0, 0, 0}, {0, 0, 1}, 0, Black).distance_m, 0.75f, 0.01f);
  EXPECT_GT(light.Gather({0, 0, 0}, {0, 0, -1}, 0, Black).distance_m, 1e9f);
}

TEST(IndirectLight, SeedsAndPlacesTurnTheDirections) {
  SceneBuilder builder;
  builder.AddQuad({0.2f, -1, 0}, {0, 2, 0}, {0, 0, 1}, builder.AddMaterial(Vec3f{}));
  builder.scene.ambient = {1, 1, 1};
  const RayTracer tracer(builder.scene);
  const auto red = [&](std::uint64_t seed, std::uint64_t place) {
    return IndirectLight(builder.scene, tracer, 64, seed)
        .Gather({0, 0, 0}, {0, 0, 1}, place, Black)
        .irradiance.x;
  };
  EXPECT_EQ(red(1, 1), red(1, 1));
  EXPECT_NE(red(1, 1), red(2, 1));
  EXPECT_NE(red(1, 1), red(1, 2));
}

// A bright slit of a hemisphere that is black else: few of the directions meet it.
TEST(IndirectLight, MoreRoundsFollowWhereDirectionsDiffer) {
  SceneBuilder builder;
  builder.AddQuad({0.2f, -5, 1}, {0.1f, 0, 0}, {0, 10, 0}, builder.AddMaterial(Vec3f{}));
  const RayTracer tracer(builder.scene);
  const auto bright = [](const TriangleHit&, const Vec3f&) { return Vec3f{1, 1, 1}; };
  const auto spread = [&](const IndirectLight::Rounds& rounds, const Vec3f& known) {
    const IndirectLight light(builder.scene, tracer, 64, 3, rounds);
    double sum = 0, squares = 0;
    for (std::uint64_t place = 0; place < 200; ++place) {
      const double e = light.Gather({0, 0, 0}, {0, 0, 1}, place, bright, known).irradiance.x;
      sum += e / 200, squares += e * e / 200;
    }
    return std::sqrt(squares - sum * sum) / sum;
  };
  const double once = spread({1, 0}, {});
  EXPECT_LT(spread({16, 0.01f}, {}), 0.4 * once);
  EXPECT_NEAR(spread({16, 1}, {}), once, 1e-12);                   // good enough at once
  EXPECT_NEAR(spread({16, 0.01f}, {100, 100, 100}), once, 1e-12);  // beside so much other light
}

}  // namespace
}  // namespace silt::sim
