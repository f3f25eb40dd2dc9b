// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_planes.h"

namespace silt::sim {

namespace {

SurfacePlane PlaneOf(const Mesh& mesh, const Triangle& triangle) {
  const Vec3d a = mesh.positions[triangle.vertex[0]].Cast<double>();
  const Vec3d e = mesh.positions[triangle.vertex[1]].Cast<double>() - a;
  const Vec3d f = mesh.positions[triangle.vertex[2]].Cast<double>() - a;
  const Vec3d n = Cross(e, f);
  const double length = Norm(n);
  SurfacePlane plane;
  if (length > 0) plane.normal = (1 / length) * n;
  plane.offset_m = Dot(plane.normal, a);
  plane.material = triangle.material + 1;
  return plane;
}

}  // namespace

std::vector<SurfacePlane> SurfacePlanes(const Scene& scene) {
  std::vector<SurfacePlane> planes;
  planes.reserve(scene.mesh.triangles.size());
  for (const Triangle& triangle : scene.mesh.triangles) {
    planes.push_back(PlaneOf(scene.mesh, triangle));
  }
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    for (std::uint32_t k = 0; k < instance.triangle_count; ++k) {
      planes[instance.first_triangle + k].instance = std::uint32_t(i + 1);
    }
  }
  return planes;
}

}  // namespace silt::sim
