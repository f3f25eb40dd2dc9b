// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "silt/sim/surface_grid.h"

namespace silt::sim {

// Lays the samples of a SurfaceGrid, triangle by triangle.
class SurfaceGridBuilder {
 public:
  SurfaceGridBuilder(const Mesh& mesh, float spacing_m, SurfaceGrid& grid)
      : mesh_(mesh), spacing_m_(spacing_m), grid_(grid) {}

  void Build();

 private:
  // Position to 1/16 mm and normal to 1/32.
  using Key = std::array<std::int32_t, 6>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Corners {
    Vec3f position[3], normal[3], center;
  };

  Corners CornersOf(const Triangle& triangle) const;
  void LayRows(std::uint32_t triangle, const Corners& corners);
  // The sample at corners·weight, new or shared. `rim`: on an edge of the triangle.
  std::uint32_t Sample(std::uint32_t triangle, const Corners& corners, const Vec3f& weight);
  void PullInwards();

  const Mesh& mesh_;
  float spacing_m_;
  SurfaceGrid& grid_;
  std::unordered_map<Key, std::uint32_t, KeyHash> known_;
  std::vector<Vec3f> inward_;  // per sample: sum of the ways to the centres of its triangles
};

}  // namespace silt::sim
