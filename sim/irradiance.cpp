// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/irradiance.h"

#include "silt/core/error.h"
#include "silt/sim/light_cache.h"

namespace silt::sim {

namespace {

// The light of fewer samples is computed in a second or so.
constexpr std::size_t kFewSamples = 20'000;

BakedLight SolveOrRead(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                       const LightingOptions& options) {
  std::optional<std::filesystem::path> file;
  if (options.cache && grid.samples().size() >= kFewSamples) file = LightCacheFile(scene, options);
  if (file) {
    if (std::optional<BakedLight> light = ReadLight(*file, grid.samples().size())) {
      return std::move(*light);
    }
  }
  BakedLight light = SolveLight(scene, tracer, grid, options);
  if (file) {
    try {
      WriteLight(*file, light);
    } catch (const Error&) {
      // A full or read-only disk costs the next run some time, and this one nothing.
    }
  }
  return light;
}

}  // namespace

Irradiance::Irradiance(const Scene& scene, const RayTracer& tracer, const LightingOptions& options)
    : grid_(scene.mesh, options.direct_spacing_m),
      light_(SolveOrRead(scene, tracer, grid_, options)) {}

}  // namespace silt::sim
