// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/coplanar_faces.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// All overlaps between the surfaces of two instances, or of one with itself, that rays can reach.
struct Tie {
  int first_instance = 0, second_instance = 0;  // in order
  double area_m2 = 0;
  Vec3d middle;                   // of the largest overlap
  bool materials_differ = false;  // somewhere in it
};

// The ties of a scene between all triangles of `tree`. An overlap counts where one of its sides is
// open: not inside of a solid (an instance that nearly every line from there leaves, as it leaves
// the book that stands on another) and not outside of everything, where nobody looks from. Ties of
// less than 1 mm² are left out.
std::vector<Tie> FindVisibleTies(const Scene& scene, const TriangleTree& tree);

}  // namespace silt::sim
