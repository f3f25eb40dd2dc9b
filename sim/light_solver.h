// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/lighting_options.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// Irradiance at the samples of a grid, on both sides; front is the side of the sample's normal.
struct StoredLight {
  std::vector<Vec3f> front, back;

  Vec3f At(const SurfaceLookup& at, bool is_front) const {
    const Vec3f* values = is_front ? front.data() : back.data();
    return at.weight[0] * values[at.sample[0]] + at.weight[1] * values[at.sample[1]] +
           at.weight[2] * values[at.sample[2]] + at.weight[3] * values[at.sample[3]];
  }
};

// Direct light from the rectangles, plus what one diffuse reflection (or none) brings from there
// and from the ambient, which also stands for all further reflections. The result is the same for
// any number of threads.
StoredLight SolveLight(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                       const LightingOptions& options);

// Mean reflectance of each material, over its texture.
std::vector<Vec3f> MeanAlbedos(const Scene& scene);

}  // namespace silt::sim
