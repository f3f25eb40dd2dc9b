// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/sim/embree_adapter.h"
#include "silt/sim/ray_packet.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// Finds what rays meet in a scene. A cut-out (Material::cutout) is pierced by rays where its
// texture's alpha is below ½. The scene must outlive the tracer.
class RayTracer {
 public:
  explicit RayTracer(const Scene& scene);

  // The nearest hit of each valid ray; triangles are numbered as in the scene's mesh.
  void Trace(const RayPacket& rays, HitPacket& hits) const { embree_.Intersect(rays, false, hits); }
  // The same, faster for rays from one eye through neighbouring pixels.
  void TraceCoherent(const RayPacket& rays, HitPacket& hits) const {
    embree_.Intersect(rays, true, hits);
  }
  // Bit i: something lies between `near` and `far` of ray i.
  std::uint32_t Occluded(const RayPacket& rays) const { return embree_.Occluded(rays); }

  // What the tracing alone of coherent packets takes, see EmbreeAdapter.
  double TimeTracing(const std::vector<RayPacket>& packets) const {
    return embree_.TimeIntersect(packets);
  }

 private:
  EmbreeAdapter embree_;
};

// Position of a hit on a triangle, in texture coordinates.
Vec2f TexcoordAt(const Mesh& mesh, const Triangle& triangle, float u, float v);

}  // namespace silt::sim
