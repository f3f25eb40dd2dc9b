// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "silt/sim/surface_grid.h"

namespace silt::sim {

// Samples that lie close together and face alike share the light of one of them, the leader.
struct SampleClusters {
  std::vector<std::uint32_t> leaders;    // samples
  std::vector<std::uint32_t> leader_of;  // by sample: index into leaders

  // Of each cluster one sample, by chance and all alike likely, or of those alone that are not
  // `left_out`, where there are any. Leaders do not stand for their cluster: they are the first of
  // it, corners of triangles more often than not, where things touch and little light arrives.
  std::vector<std::uint32_t> AnyOfEach(const std::vector<bool>& left_out, std::uint64_t seed) const;
};

// One cluster for each cube of a grid of the sample's own width, and direction that it faces.
SampleClusters ClusterSamples(const std::vector<SurfaceSample>& samples,
                              const std::vector<float>& width_m);

// Finds leaders, or other samples, about a place.
class SampleNeighbours {
 public:
  // Those of the samples that `chosen` names; all must outlive this. `cell_m`: about the radius.
  SampleNeighbours(const std::vector<SurfaceSample>& samples,
                   const std::vector<std::uint32_t>& chosen, float cell_m);

  // Calls visit(i, distance) for each chosen[i] within the radius, in an order that depends on the
  // samples alone.
  template <typename Visitor>
  void Visit(const Vec3f& center, float radius_m, const Visitor& visit) const {
    const Vec3f reach{radius_m, radius_m, radius_m};
    const Cell low = CellOf(center - reach), high = CellOf(center + reach);
    for (std::int32_t z = low[2]; z <= high[2]; ++z) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (std::uint32_t i = found->second.begin; i < found->second.end; ++i) {
            const float distance_m = Norm(samples_[chosen_[sorted_[i]]].position - center);
            if (distance_m <= radius_m) visit(sorted_[i], distance_m);
          }
        }
      }
    }
  }

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Range {
    std::uint32_t begin = 0, end = 0;
  };
  Cell CellOf(const Vec3f& position) const;

  const std::vector<SurfaceSample>& samples_;
  const std::vector<std::uint32_t>& chosen_;
  float cell_m_;
  std::vector<std::uint32_t> sorted_;  // indices into chosen_, cell by cell
  std::unordered_map<Cell, Range, CellHash> cells_;
};

}  // namespace silt::sim
