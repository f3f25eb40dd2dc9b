// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// The plane normal·x = offset of a triangle in the world, and whose it is. In double: exact, where
// Embree's own distances are rounded to float. The normal of a triangle without area is 0.
struct SurfacePlane {
  Vec3d normal;  // unit, on the front
  double offset_m = 0;
  std::uint32_t instance = 0, material = 0;  // index in the scene + 1; 0: of no instance

  // Where along a ray it meets the plane, in lengths of its direction; not finite where never.
  double Distance(const Vec3d& origin, const Vec3d& direction) const {
    return (offset_m - Dot(normal, origin)) / Dot(normal, direction);
  }
};

// One for each triangle of the scene's mesh.
std::vector<SurfacePlane> SurfacePlanes(const Scene& scene);

}  // namespace silt::sim
