// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sample_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "silt/core/random.h"

namespace silt::sim {

namespace {

template <std::size_t n>
std::size_t HashOf(const std::array<std::int32_t, n>& key) {
  std::uint64_t hash = 0;
  for (const std::int32_t k : key) {
    hash = (hash ^ std::uint32_t(k)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return std::size_t(hash);
}

// Cube, direction to about 30°, width in tenths of a millimetre, and on wide triangles the plane to
// a millimetre: sheets that lie on each other must not share.
using ClusterKey = std::array<std::int32_t, 8>;
constexpr float kPlanesPerMetre = 1000;

ClusterKey KeyOf(const SurfaceSample& sample, float width_m) {
  const auto cube = [&](float x) { return std::int32_t(std::floor(x / width_m)); };
  const auto turn = [](float x) { return std::int32_t(std::lround(2 * x)); };
  const Vec3f &p = sample.position, &n = sample.normal;
  return {cube(p.x),
          cube(p.y),
          cube(p.z),
          turn(n.x),
          turn(n.y),
          turn(n.z),
          std::int32_t(std::lround(1e4f * width_m)),
          sample.on_wide_triangle ? std::int32_t(std::lround(kPlanesPerMetre * Dot(n, p))) : 0};
}

}  // namespace

SampleClusters ClusterSamples(const std::vector<SurfaceSample>& samples,
                              const std::vector<float>& width_m) {
  SampleClusters clusters;
  clusters.leader_of.reserve(samples.size());
  std::unordered_map<ClusterKey, std::uint32_t, decltype(&HashOf<8>)> known(samples.size() / 4 + 16,
                                                                            &HashOf<8>);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const auto [entry, is_new] =
        known.try_emplace(KeyOf(samples[i], width_m[i]), std::uint32_t(clusters.leaders.size()));
    if (is_new) clusters.leaders.push_back(i);
    clusters.leader_of.push_back(entry->second);
  }
  return clusters;
}

std::vector<std::uint32_t> SampleClusters::AnyOfEach(const std::vector<bool>& left_out,
                                                     std::uint64_t seed) const {
  std::vector<std::uint32_t> chosen = leaders;
  std::vector<std::uint32_t> candidates(leaders.size(), 0);
  const CounterRandom random(seed, 0);
  for (std::uint32_t i = 0; i < leader_of.size(); ++i) {
    if (left_out[i]) continue;
    // The n-th candidate takes the place of those before it in one case of n.
    const std::uint32_t cluster = leader_of[i];
    if (random.Uniform(i) * double(++candidates[cluster]) < 1) chosen[cluster] = i;
  }
  return chosen;
}

std::size_t SampleNeighbours::CellHash::operator()(const Cell& cell) const { return HashOf(cell); }

SampleNeighbours::Cell SampleNeighbours::CellOf(const Vec3f& p) const {
  const auto index = [&](float x) { return std::int32_t(std::floor(x / cell_m_)); };
  return {index(p.x), index(p.y), index(p.z)};
}

SampleNeighbours::SampleNeighbours(const std::vector<SurfaceSample>& samples,
                                   const std::vector<std::uint32_t>& chosen, float cell_m)
    : samples_(samples), chosen_(chosen), cell_m_(cell_m), sorted_(chosen.size()) {
  std::vector<Cell> cell(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) cell[i] = CellOf(samples[chosen[i]].position);
  std::iota(sorted_.begin(), sorted_.end(), 0u);
  std::sort(sorted_.begin(), sorted_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cell[a] != cell[b] ? cell[a] < cell[b] : a < b;
  });
  for (std::uint32_t i = 0; i < sorted_.size(); ++i) {
    Range& range = cells_.try_emplace(cell[sorted_[i]], Range{i, i}).first->second;
    range.end = i + 1;
  }
}

}  // namespace silt::sim
