// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sample_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "silt/core/random.h"

namespace silt::sim {
namespace {

std::vector<SurfaceSample> Cloud(std::size_t n) {
  const CounterRandom random(2);
  std::vector<SurfaceSample> samples;
  for (std::uint64_t i = 0; i < n; ++i) {
    samples.push_back({{float(random.Uniform(3 * i)) - 0.5f, float(random.Uniform(3 * i + 1)),
                        float(random.Uniform(3 * i + 2))},
                       i % 2 ? Vec3f{0, 0, 1} : Vec3f{0, 1, 0}});
  }
  return samples;
}

TEST(SampleClusters, MembersAreNearTheirLeaderAndFaceAlike) {
  const auto samples = Cloud(2000);
  std::vector<float> width(2000, 0.2f);
  for (std::size_t i = 0; i < 500; ++i) width[i] = 0.1f;
  const SampleClusters clusters = ClusterSamples(samples, width);
  EXPECT_LT(clusters.leaders.size(), 1200u);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t leader = clusters.leaders[clusters.leader_of[i]];
    EXPECT_LE(Norm(samples[leader].position - samples[i].position), 1.7321f * width[i]);
    EXPECT_GT(Dot(samples[leader].normal, samples[i].normal), 0.99f);
    EXPECT_EQ(width[leader], width[i]);
  }
  for (std::uint32_t k = 0; k < clusters.leaders.size(); ++k) {
    EXPECT_EQ(clusters.leader_of[clusters.leaders[k]], k);
  }
}

// A millimetre apart in one cube: sheets share where they are small, but not where they are wide.
TEST(SampleClusters, WideSheetsOnEachOtherDoNotShare) {
  std::vector<SurfaceSample> sheets{{{0.1f, 0.1f, 0.1f}, {0, 0, 1}},
                                    {{0.1f, 0.1f, 0.101f}, {0, 0, 1}}};
  const std::vector<float> width(2, 0.2f);
  EXPECT_EQ(ClusterSamples(sheets, width).leaders.size(), 1u);
  for (SurfaceSample& sheet : sheets) sheet.on_wide_triangle = true;
  EXPECT_EQ(ClusterSamples(sheets, width).leaders.size(), 2u);
}

TEST(SampleClusters, AnyOfEachIsOneOfItsMembersEachAsOften) {
  const auto samples = Cloud(400);
  const SampleClusters clusters = ClusterSamples(samples, std::vector<float>(400, 0.5f));
  std::vector<double> members(clusters.leaders.size()), chosen(400);
  for (const std::uint32_t cluster : clusters.leader_of) ++members[cluster];
  constexpr int draws = 4000;
  for (std::uint64_t seed = 0; seed < draws; ++seed) {
    const auto any = clusters.AnyOfEach(std::vector<bool>(400, false), seed);
    for (std::uint32_t k = 0; k < any.size(); ++k) {
      ASSERT_EQ(clusters.leader_of[any[k]], k);
      ++chosen[any[k]];
    }
  }
  for (std::size_t i = 0; i < 400; ++i) {
    const double expected = draws / members[clusters.leader_of[i]];
    EXPECT_NEAR(chosen[i], expected, 5 * std::sqrt(expected)) << i;  // of 400, one in 4,000 runs
  }
}

TEST(SampleClusters, AnyOfEachLeavesOutWhereItCan) {
  const auto samples = Cloud(400);
  const SampleClusters clusters = ClusterSamples(samples, std::vector<float>(400, 0.5f));
  std::vector<bool> left_out(400, false);
  for (const std::uint32_t leader : clusters.leaders) left_out[leader] = true;
  for (std::uint32_t i = 0; i < 400; ++i) left_out[i] = left_out[i] || clusters.leader_of[i] == 0;
  const auto any = clusters.AnyOfEach(left_out, 5);
  EXPECT_EQ(any[0], clusters.leaders[0]);  // all of it are left out
  for (std::uint32_t k = 1; k < any.size(); ++k) EXPECT_FALSE(left_out[any[k]]) << k;
}

TEST(SampleNeighbours, FindsAllWithinTheRadius) {
  const auto samples = Cloud(500);
  std::vector<std::uint32_t> even(250);
  for (std::uint32_t i = 0; i < 250; ++i) even[i] = 2 * i;
  const SampleNeighbours neighbours(samples, even, 0.1f);
  for (const float radius : {0.02f, 0.1f, 0.37f}) {
    const Vec3f center = samples[7].position;
    std::vector<std::uint32_t> found, expected;
    neighbours.Visit(center, radius, [&](std::uint32_t i, float distance_m) {
      EXPECT_EQ(distance_m, Norm(samples[even[i]].position - center));
      found.push_back(i);
    });
    for (std::uint32_t i = 0; i < even.size(); ++i) {
      if (Norm(samples[even[i]].position - center) <= radius) expected.push_back(i);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace silt::sim
