// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/bsdf.h"
#include "silt/sim/sampling.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// Distance by which rays start off the surface that they leave.
inline constexpr float kRayOffsetM = 5e-4f;

// What a ray has met, as its light sees it.
struct SurfacePoint {
  Vec3f origin;          // on the surface, kRayOffsetM off it on the side that the ray met
  Vec3f normal;          // of the triangle, unit, on that side
  TangentFrame shading;  // about the interpolated normal, on that side
  Bsdf bsdf;
  Vec3f emission;
  bool black;  // the back of a one-sided material
};

struct TriangleHit {
  std::uint32_t triangle;
  float u, v;
  bool front;
};

// With the textures' full detail. A direction of the shading frame may point into the triangle: it
// meets that triangle then.
SurfacePoint MakeSurfacePoint(const Scene& scene, const TriangleHit& hit, bool with_reflection);

// Unit normal by the right-hand rule; +z where the triangle has no area.
Vec3f FrontNormal(const Mesh& mesh, const Triangle& triangle);
// A vertex's normal on the front side of the triangle: models disagree about which side is out.
Vec3f VertexNormal(const Mesh& mesh, std::uint32_t vertex, const Vec3f& front);

}  // namespace silt::sim
