// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/direct_light.h"
#include "silt/sim/lighting_options.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// The light that falls on every surface of a scene, computed once: direct light from the
// rectangles, and light that one diffuse reflection (or none) brings from there and from the
// ambient, which also stands for all further reflections. The result is the same for any number of
// threads.
class Irradiance {
 public:
  Irradiance(const Scene& scene, const RayTracer& tracer, const LightingOptions& options);

  // ∫ L cos θ dω at a point of a triangle, on its front (counter-clockwise) or back.
  Vec3f At(std::uint32_t triangle, float u, float v, bool front) const {
    return Interpolate(grid_.Locate(triangle, u, v), front);
  }

  const SurfaceGrid& grid() const { return grid_; }

 private:
  Vec3f Interpolate(const SurfaceLookup& at, bool front) const;

  SurfaceGrid grid_;
  std::vector<Vec3f> front_, back_;  // per sample of the grid
};

}  // namespace silt::sim
