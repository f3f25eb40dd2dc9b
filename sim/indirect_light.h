// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "silt/sim/ray_tracer.h"

namespace silt::sim {

// Radiance that a surface sends towards a ray that hits it.
using SurfaceRadiance = std::function<Vec3f(std::uint32_t triangle, float u, float v, bool front)>;

// Light that arrives from surfaces, and from the ambient where a direction meets none:
// E = π/N Σ L(ω_i) over a fixed set of N directions with density cos θ / π.
class IndirectLight {
 public:
  IndirectLight(const Scene& scene, const RayTracer& tracer, int directions);

  Vec3f Irradiance(const Vec3f& position, const Vec3f& unit_normal,
                   const SurfaceRadiance& radiance) const;

 private:
  const Scene& scene_;
  const RayTracer& tracer_;
  std::vector<Vec3f> directions_;  // about +z
};

}  // namespace silt::sim
