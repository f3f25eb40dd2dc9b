// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "silt/core/vector.h"
#include "silt/sim/mesh.h"

// Simple solids, appended to a mesh. All are seen from outside: triangles run counter-clockwise and
// normals point outward. Lengths in metres.
namespace silt::sim {

// What a face is covered with. With `tile_m` the picture repeats at that width and height, else it
// covers the face once.
struct Cover {
  std::uint32_t material = 0;
  std::optional<Vec2f> tile_m;
};

// Corner, corner + u, corner + u + v, corner + v; the front is where u × v points, and the lower
// left corner of the picture lies at `corner`.
void AppendQuad(Mesh& mesh, const Vec3d& corner, const Vec3d& u, const Vec3d& v,
                const Cover& cover);

struct Box {
  Vec3d size;
  Vec3d at;                    // centre of the bottom face
  double yaw_rad = 0;          // about z, counter-clockwise from above
  std::array<Cover, 6> faces;  // top, bottom, front (−y), back, left (−x), right
};
void AppendBox(Mesh& mesh, const Box& box);

// Of longitude × latitude, so that its vertices lie on the sphere and its faces within. With
// `tile_m` a whole number of pictures goes around.
struct Sphere {
  Vec3d center;
  double radius = 0;
  int segments = 48;  // around; half as many from pole to pole
  Cover cover;
};
void AppendSphere(Mesh& mesh, const Sphere& sphere);

// Upright and closed; its vertices lie on the cylinder.
struct Cylinder {
  Vec3d at;  // centre of the base
  double radius = 0, height = 0;
  int segments = 48;
  Cover cover;
};
void AppendCylinder(Mesh& mesh, const Cylinder& cylinder);

}  // namespace silt::sim
