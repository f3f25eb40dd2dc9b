// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/irradiance.h"
#include "silt/sim/path_tracer.h"

namespace silt::sim {

// View-dependent reflection on top of light that is stored on surfaces: coats, metals and mirrors
// by kPaths paths that end in the stored light. The paths' random numbers are the same for every
// pixel and frame: what they miss is a pattern, not noise.
class Reflection {
 public:
  // All must outlive this.
  Reflection(const Scene& scene, const RayTracer& tracer, const Irradiance& irradiance);

  static constexpr int kPaths = kPacketSize;

  // Whether a triangle's material reflects at all.
  bool Reflects(std::uint32_t triangle) const {
    return reflects_[scene_.mesh.triangles[triangle].material];
  }

  // Radiance against a ray of that direction, from the radiance that the surface would have were it
  // matt.
  Vec3f Over(const Vec3f& matt, const TriangleHit& hit, const Vec3f& direction) const;

 private:
  const Scene& scene_;
  PathTracer tracer_;
  std::vector<bool> reflects_;  // by material
};

}  // namespace silt::sim
