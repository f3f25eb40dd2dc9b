// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/fine_light.h"
#include "silt/sim/lighting_options.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// All light that falls on the samples of a grid, and between them where these do not tell it:
// directly from the rectangles, and from surfaces and background after any number of reflections.
// Surfaces are matt, or reflect where the options say so. The result is the same for any number of
// threads.
BakedLight SolveLight(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                      const LightingOptions& options);

}  // namespace silt::sim
