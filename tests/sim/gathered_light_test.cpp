// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/gathered_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/random.h"

namespace silt::sim {
namespace {

// A row along x, 1 cm apart, facing up.
std::vector<SurfaceSample> Row(int n) {
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < n; ++i) samples.push_back({{0.01f * float(i), 0, 0}, {0, 0, 1}});
  return samples;
}

Gathered Found(float irradiance, bool buried = false) {
  Gathered g;
  g.irradiance = {irradiance, 0, 0};
  g.buried = buried;
  g.distance_m = 1e30f;
  return g;
}

TEST(GatheredLight, WidthsFollowTheDistance) {
  const auto samples = Row(40);
  const SampleClusters coarse = ClusterSamples(samples, std::vector<float>(40, 0.2f));
  ASSERT_EQ(coarse.leaders.size(), 2u);  // the first, and one half way
  const auto widths = [&](float first_m, float second_m) {
    return GatherWidths(samples, coarse, {first_m, second_m}, 0.01f, 0.16f);
  };
  EXPECT_EQ(widths(0.01f, 100)[0], 0.01f);
  EXPECT_EQ(widths(0.01f, 100)[30], 0.16f);
  EXPECT_EQ(widths(0.2f, 0.2f)[0], 0.04f);   // a fourth is 5 cm
  EXPECT_EQ(widths(0.2f, 0.2f)[10], 0.01f);  // 10 cm from the leader, which saw something at 20
}

TEST(GatheredLight, WidthsNarrowWhereASampleItselfSeesThingsNearby) {
  std::vector<Gathered> near(4);
  const float distance_m[] = {100, 0.4f, 0.3f, 0.001f};
  for (std::size_t i = 0; i < 4; ++i) near[i].distance_m = distance_m[i];
  std::vector<float> width{0.1f, 0.1f, 0.1f, 0.1f};
  NarrowBy(near, 0.025f, width);
  EXPECT_EQ(width, (std::vector<float>{0.1f, 0.1f, 0.05f, 0.025f}));
}

// A plane of light that grows along x comes back as it is; noise comes back smaller.
TEST(GatheredLight, InterpolatesBetweenLeaders) {
  const auto samples = Row(400);
  const std::vector<float> width(400, 0.08f);
  const SampleClusters clusters = ClusterSamples(samples, width);
  std::vector<Gathered> gathered;
  for (const std::uint32_t leader : clusters.leaders) gathered.push_back(Found(float(leader)));
  const std::vector<Vec3f> light = Interpolated(samples, clusters, width, gathered);
  for (std::size_t i = 50; i < 350; ++i) EXPECT_NEAR(light[i].x, float(i), 2.5f);
}

// At a rim all places of known light lie on one side.
TEST(GatheredLight, GrowsOnToTheRim) {
  const auto samples = Row(400);
  const std::vector<float> width(400, 0.08f);
  const SampleClusters clusters = ClusterSamples(samples, width);
  std::vector<Gathered> gathered;
  for (const std::uint32_t leader : clusters.leaders) {
    gathered.push_back(Found(1000 - float(leader)));
  }
  const std::vector<Vec3f> light = Interpolated(samples, clusters, width, gathered);
  EXPECT_NEAR(light[0].x, 1000, 1.5f);
  EXPECT_NEAR(light[3].x, 997, 1.5f);
}

TEST(GatheredLight, DoesNotMixPlanesNormalsAndBuriedLeaders) {
  std::vector<SurfaceSample> samples = Row(8);
  samples[1].position.z = 0.05f;
  samples[2].normal = {1, 0, 0};
  const std::vector<float> width(8, 0.01f);
  const SampleClusters clusters = ClusterSamples(samples, width);
  ASSERT_EQ(clusters.leaders.size(), 8u);
  std::vector<Gathered> gathered(8, Found(1));
  gathered[1] = gathered[2] = Found(9);
  gathered[4] = Found(9, true);
  const std::vector<Vec3f> light = Interpolated(samples, clusters, width, gathered);
  for (const std::size_t i : {0, 3, 5, 6, 7}) EXPECT_FLOAT_EQ(light[i].x, 1) << i;
  for (const std::size_t i : {1, 2, 4}) EXPECT_FLOAT_EQ(light[i].x, 9) << i;
}

// A poster 15 mm off its wall, however wide the area that shares a gathering.
TEST(GatheredLight, DoesNotMixSheetsThatHangOnEachOther) {
  std::vector<SurfaceSample> samples = Row(40);
  for (std::size_t i = 0; i < 40; i += 2) samples[i].position.z = 0.015f;
  const std::vector<float> width(40, 0.01f), wide(40, 0.16f);
  SampleClusters clusters = ClusterSamples(samples, width);
  std::vector<Gathered> gathered;
  for (const std::uint32_t leader : clusters.leaders) gathered.push_back(Found(leader % 2 ? 9 : 1));
  const std::vector<Vec3f> light = Interpolated(samples, clusters, wide, gathered);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_FLOAT_EQ(light[i].x, i % 2 ? 9 : 1) << i;
}

TEST(GatheredLight, BuriedSamplesTakeTheLightOfTheNearest) {
  const auto samples = Row(10);
  std::vector<Vec3f> light(10);
  for (std::size_t i = 0; i < 10; ++i) light[i] = {float(i), 0, 0};
  std::vector<bool> buried(10, false);
  for (const std::size_t i : {4, 5, 6, 7, 8, 9}) buried[i] = true;
  FillBuried(samples, buried, 0.025f, light);
  EXPECT_NEAR(light[4].x, 3, 0.1f);
  EXPECT_EQ(light[5].x, 3);
  EXPECT_EQ(light[6].x, 6);  // too far from all
  EXPECT_EQ(light[3].x, 3);
}

}  // namespace
}  // namespace silt::sim
