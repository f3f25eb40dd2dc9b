// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/ray_tracer.h"

#include <utility>

namespace silt::sim {

namespace {

bool IsCutout(const Scene& scene, const Triangle& triangle) {
  const Material& material = scene.materials[triangle.material];
  return material.cutout && material.texture >= 0;
}

// Solid triangles apart from cut-outs: only the latter pay for the question whether they are there.
std::vector<TriangleSet> SplitBySolidity(const Scene& scene) {
  std::vector<TriangleSet> sets(2);
  for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    const Triangle& t = scene.mesh.triangles[i];
    TriangleSet& set = sets[IsCutout(scene, t) ? 1 : 0];
    set.vertices.push_back({t.vertex[0], t.vertex[1], t.vertex[2]});
    set.numbers.push_back(std::uint32_t(i));
  }
  sets[1].filter = [&scene](std::uint32_t number, float u, float v) {
    const Triangle& triangle = scene.mesh.triangles[number];
    const Vec2f uv = TexcoordAt(scene.mesh, triangle, u, v);
    const int texture = scene.materials[triangle.material].texture;
    return scene.textures[std::size_t(texture)].Alpha(uv.x, uv.y) >= 0.5f;
  };
  return sets;
}

}  // namespace

Vec2f TexcoordAt(const Mesh& mesh, const Triangle& triangle, float u, float v) {
  const Vec2f& a = mesh.texcoords[triangle.vertex[0]];
  const Vec2f& b = mesh.texcoords[triangle.vertex[1]];
  const Vec2f& c = mesh.texcoords[triangle.vertex[2]];
  return (1 - u - v) * a + u * b + v * c;
}

RayTracer::RayTracer(const Scene& scene) : embree_(scene.mesh.positions, SplitBySolidity(scene)) {}

}  // namespace silt::sim
