// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/mesh.h"

namespace silt::sim {

// A triangle of a mesh as light sees it; weights are barycentric.
struct TriangleCorners {
  Vec3f position[3];
  Vec3f normal[3];  // shading normals, unit, on the front
  Vec3f front;      // unit

  TriangleCorners(const Mesh& mesh, const Triangle& triangle);

  Vec3f Position(const Vec3f& weight) const;
  Vec3f Normal(const Vec3f& weight) const;  // unit

  // From the edges on which a point lies, at right angles to them, a millimetre or less: 0 inside.
  // A point that is moved so is out of what the triangle touches there.
  Vec3f Inward(const Vec3f& weight) const;
  static constexpr float kInwardM = 1e-3f;
};

}  // namespace silt::sim
