// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene_builder.h"
#include "silt/core/random.h"
#include "silt/sim/irradiance.h"

namespace silt::sim {
namespace {

// A floor of triangles 0 and 1 under a lamp, and on it what one adds.
SceneBuilder LampOverFloor() {
  SceneBuilder builder;
  builder.AddQuad({0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0},
                  builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f}));
  builder.AddLight({0.2f, 0.2f, 1}, {0, 0.1f, 0}, {0.1f, 0, 0}, {50, 50, 50});
  return builder;
}

// Differences of stored from exact light on the floor from (low, low) to (high, high), which lies
// within triangle 0, in shares of the open floor's light; of direct light alone, since nothing in
// the scene reflects.
std::vector<float> Differences(const Scene& scene, float tolerance, float low, float high) {
  const RayTracer tracer(scene);
  LightingOptions options;
  options.refine_tolerance = tolerance;
  const Irradiance stored(scene, tracer, options);
  const DirectLight exact(scene, tracer, 16);
  const float open = stored.At(0, 0.05f, 0.02f, true).x;
  const CounterRandom random(5);
  std::vector<float> differences;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto at = [&](std::uint64_t k) {
      return low + (high - low) * float(random.Uniform(2 * i + k));
    };
    const float x = std::max(at(0), at(1)), y = std::min(at(0), at(1));
    const float expected = exact.Irradiance({x, y, 0}, {0, 0, 1}).x;
    // (0 0), (0.5 0), (0.5 0.5)
    const float found = stored.At(0, 2 * (x - y), 2 * y, true).x;
    differences.push_back(std::abs(found - expected) / open);
  }
  std::sort(differences.begin(), differences.end());
  return differences;
}

double Mean(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum / double(values.size());
}

struct Means {
  double refined, plain;  // with fine cells, and without
  float refined_p99;
};

Means MeansOf(const Scene& scene, float low, float high) {
  const std::vector<float> refined = Differences(scene, 0.03f, low, high);
  return {Mean(refined), Mean(Differences(scene, 10, low, high)),
          refined[refined.size() * 99 / 100]};
}

// The shadow of a bar that is thinner than samples are apart.
TEST(LightRefinement, FindsAThinShadowBetweenSamples) {
  SceneBuilder builder = LampOverFloor();
  builder.AddBox({0.1f, 0.25f, 0.1f}, {0.45f, 0.262f, 0.112f}, builder.AddMaterial(Vec3f{}));
  const Means means = MeansOf(builder.scene, 0.2f, 0.4f);
  EXPECT_LT(means.refined, 0.3 * means.plain);
  EXPECT_LT(means.refined, 0.009);
  EXPECT_LT(means.refined_p99, 0.11f);
}

// Beside a box that stands on the floor: of the places below the box nobody sees any, and their
// darkness does not leak out from under it.
TEST(LightRefinement, LeavesOutWhatLiesUnderThings) {
  SceneBuilder builder = LampOverFloor();
  builder.AddBox({0.2f, 0.2f, 0}, {0.3f, 0.3f, 0.1f}, builder.AddMaterial(Vec3f{}));
  const Means means = MeansOf(builder.scene, 0.301f, 0.4f);
  EXPECT_LT(means.refined, 0.6 * means.plain);
  EXPECT_LT(means.refined, 0.006);
}

// Nothing is close, and the lamp's light is smooth.
TEST(LightRefinement, AnOpenFloorIsStoredAsItIs) {
  const Scene scene = LampOverFloor().scene;
  const RayTracer tracer(scene);
  EXPECT_TRUE(Irradiance(scene, tracer, {}).fine().patches().empty());
}

}  // namespace
}  // namespace silt::sim
