// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/sim/scene.h"
#include "silt/sim/triangle_tree.h"

namespace silt::sim {

// Nearer than this, rounding decides which of two surfaces a ray meets first.
inline constexpr double kTieDistance_m = 1e-5;

// Two triangles that lie on each other: overlapping over an area, nowhere farther apart than
// kTieDistance_m.
struct FaceOverlap {
  std::uint32_t first = 0, second = 0;  // triangles, first < second
  double area_m2 = 0;
  Vec3d middle;  // of the overlap
};

// All overlaps of more than a thousandth of the smaller triangle, in order of their triangles,
// whatever the number of threads. `tree` holds the scene's triangles.
std::vector<FaceOverlap> FindOverlaps(const Mesh& mesh, const TriangleTree& tree);

}  // namespace silt::sim
