// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/gathered_light.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr float kShareOfDistance = 0.25f, kCaution = 1.5f;
constexpr float kRadiusInWidths = 1.5f;
constexpr float kSameNormal = 0.06f;  // 1 − cos of the angle at which the weight is 0: 20°
constexpr float kSheetM = 1e-3f;      // what is so close is one sheet
constexpr int kBlock = 1024;

template <typename Body>
void ForBlocks(std::size_t n, const Body& body) {
  ParallelFor(int((n + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t first = std::size_t(block) * kBlock;
    for (std::size_t i = first; i < std::min(n, first + kBlock); ++i) body(i);
  });
}

// 1 where both face alike, down to 0; 0 where they lie on different surfaces: one that bends by an
// angle between two points leaves its tangent plane by at most the angle times their distance.
float Likeness(const SurfaceSample& a, const SurfaceSample& b) {
  const Vec3f way = b.position - a.position;
  const float bend = std::max(0.0f, 1 - Dot(a.normal, b.normal));
  if (std::abs(Dot(way, a.normal)) > kSheetM + std::sqrt(2 * bend) * Norm(way)) return 0;
  return std::max(0.0f, 1 - bend / kSameNormal);
}

}  // namespace

std::vector<float> GatherWidths(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& coarse,
                                const std::vector<float>& leader_distance_m, float finest_m,
                                float widest_m) {
  std::vector<float> widths(samples.size(), finest_m);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t leader = coarse.leader_of[i];
    const float away = Norm(samples[coarse.leaders[leader]].position - samples[i].position);
    const float width = kShareOfDistance * (leader_distance_m[leader] - kCaution * away);
    while (widths[i] * 2 <= std::min(width, widest_m)) widths[i] *= 2;
  }
  return widths;
}

void NarrowBy(const std::vector<Gathered>& near, float finest_m, std::vector<float>& width_m) {
  for (std::size_t i = 0; i < near.size(); ++i) {
    const float most = kShareOfDistance * near[i].distance_m;
    while (width_m[i] > finest_m && width_m[i] > most) width_m[i] /= 2;
  }
}

std::vector<Vec3f> Interpolated(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& clusters, const std::vector<float>& width_m,
                                const std::vector<Gathered>& gathered) {
  std::map<float, std::unique_ptr<SampleNeighbours>> neighbours;
  for (const std::uint32_t leader : clusters.leaders) {
    auto& of_width = neighbours[width_m[leader]];
    if (of_width) continue;
    of_width = std::make_unique<SampleNeighbours>(samples, clusters.leaders,
                                                  kRadiusInWidths * width_m[leader]);
  }
  std::vector<Vec3f> result(samples.size());
  ForBlocks(samples.size(), [&](std::size_t i) {
    const SurfaceSample& mine = samples[i];
    const float radius = kRadiusInWidths * width_m[i];
    Vec3f sum;
    float total = 0;
    neighbours.at(width_m[i])->Visit(mine.position, radius, [&](std::uint32_t j, float away_m) {
      if (gathered[j].buried) return;
      const SurfaceSample& other = samples[clusters.leaders[j]];
      const float weight = (1 - away_m / radius) * Likeness(mine, other);
      sum += weight * gathered[j].irradiance;
      total += weight;
    });
    const bool alone = !(total > 1e-3f) || gathered[clusters.leader_of[i]].buried;
    result[i] = alone ? gathered[clusters.leader_of[i]].irradiance : (1 / total) * sum;
  });
  return result;
}

void FillBuried(const std::vector<SurfaceSample>& samples, const std::vector<bool>& buried,
                float radius_m, std::vector<Vec3f>& irradiance) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (!buried[i]) open.push_back(i);
  }
  const SampleNeighbours neighbours(samples, open, radius_m);
  const std::vector<Vec3f> before = irradiance;
  ForBlocks(samples.size(), [&](std::size_t i) {
    if (!buried[i]) return;
    Vec3f sum;
    float total = 0;
    neighbours.Visit(samples[i].position, radius_m, [&](std::uint32_t j, float away_m) {
      const float closeness = 1 / (away_m + 1e-4f);
      const float weight =
          closeness * closeness * closeness * closeness * Likeness(samples[i], samples[open[j]]);
      sum += weight * before[open[j]];
      total += weight;
    });
    if (total > 0) irradiance[i] = (1 / total) * sum;
  });
}

}  // namespace silt::sim
