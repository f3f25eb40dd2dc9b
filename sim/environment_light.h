// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

// Light that arrives straight from a scene's Environment, from a fixed set of directions drawn by
// its brightness, the same at every point: E = 1/N Σ L(ω) cos θ V(ω) / density(ω).
class EnvironmentLight {
 public:
  // None where the scene has no Environment: a constant ambient is left to gathering.
  EnvironmentLight(const Scene& scene, const RayTracer& tracer, int directions);

  Vec3f Irradiance(const Vec3f& position, const Vec3f& unit_normal) const;

 private:
  struct Beam {
    Vec3f direction;
    Vec3f power;  // L / (N density)
  };

  const RayTracer& tracer_;
  std::vector<Beam> beams_;
};

}  // namespace silt::sim
