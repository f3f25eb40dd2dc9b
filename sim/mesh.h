// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

// Counter-clockwise seen from the front.
struct Triangle {
  std::uint32_t vertex[3];
  std::uint32_t material;  // index into Scene::materials
};

// All surfaces of a scene, in world coordinates: metres, z up. `normals` and `texcoords` are as
// long as `positions`.
struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;    // unit; of the triangle itself where a model brings none
  std::vector<Vec2f> texcoords;  // (0, 0) is the lower left corner of the picture
  std::vector<Triangle> triangles;
};

}  // namespace silt::sim
