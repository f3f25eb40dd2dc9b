// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/sim/sample_index.h"
#include "silt/sim/surface_grid.h"
#include "silt/sim/triangle_corners.h"

namespace silt::sim {

// Lays the samples of a SurfaceGrid, triangle by triangle.
class SurfaceGridBuilder {
 public:
  SurfaceGridBuilder(const Mesh& mesh, float spacing_m, SurfaceGrid& grid)
      : mesh_(mesh), spacing_m_(spacing_m), grid_(grid), known_(mesh.positions.size()) {}

  void Build();

 private:
  void LayRows(std::uint32_t triangle, const TriangleCorners& corners);
  // The sample at corners·weight, new or shared. `rim`: on an edge of the triangle.
  std::uint32_t Sample(std::uint32_t triangle, const TriangleCorners& corners, const Vec3f& weight);
  void PullInwards();

  const Mesh& mesh_;
  float spacing_m_;
  SurfaceGrid& grid_;
  SampleIndex known_;
  struct Rim {
    Vec3f inward, front;  // sums over the triangles that meet there
  };
  std::vector<Rim> rims_;  // per sample
};

}  // namespace silt::sim
