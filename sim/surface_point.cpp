// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_point.h"

#include "silt/sim/ray_tracer.h"

namespace silt::sim {

namespace {

Vec3f SafelyNormalized(const Vec3f& v, const Vec3f& otherwise) {
  const float norm = Norm(v);
  return norm > 1e-12f ? (1 / norm) * v : otherwise;
}

}  // namespace

Vec3f FrontNormal(const Mesh& mesh, const Triangle& triangle) {
  const Vec3f& a = mesh.positions[triangle.vertex[0]];
  return SafelyNormalized(
      Cross(mesh.positions[triangle.vertex[1]] - a, mesh.positions[triangle.vertex[2]] - a),
      {0, 0, 1});
}

Vec3f VertexNormal(const Mesh& mesh, std::uint32_t vertex, const Vec3f& front) {
  const Vec3f n = SafelyNormalized(mesh.normals[vertex], front);
  return Dot(n, front) < 0 ? -n : n;
}

SurfacePoint MakeSurfacePoint(const Scene& scene, const TriangleHit& hit, bool with_reflection) {
  const Mesh& mesh = scene.mesh;
  const Triangle& triangle = mesh.triangles[hit.triangle];
  const Material& material = scene.materials[triangle.material];
  const Vec3f front = FrontNormal(mesh, triangle);
  const float weight[3] = {1 - hit.u - hit.v, hit.u, hit.v};
  Vec3f position, smooth;
  for (int i = 0; i < 3; ++i) {
    position += weight[i] * mesh.positions[triangle.vertex[i]];
    smooth += weight[i] * VertexNormal(mesh, triangle.vertex[i], front);
  }
  smooth = SafelyNormalized(smooth, front);
  Vec3f texel{1, 1, 1};
  if (material.texture >= 0) {
    // Of level 0, whatever the ray's cone: the reference's many samples average the texture
    // themselves, over the very footprint of a pixel and through every bounce, where a mip level
    // would blur it in advance. With few samples it aliases, and so do reflections on baked light.
    const Vec2f uv = TexcoordAt(mesh, triangle, hit.u, hit.v);
    texel = scene.textures[std::size_t(material.texture)].Sample(uv.x, uv.y, 0);
  }
  const Vec3f normal = hit.front ? front : -front;
  return {position + kRayOffsetM * normal,
          normal,
          TangentFrame(hit.front ? smooth : -smooth),
          Bsdf(material, material.diffuse * texel, with_reflection),
          material.emission * texel,
          !hit.front && !material.two_sided};
}

}  // namespace silt::sim
