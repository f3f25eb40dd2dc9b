// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/irradiance.h"

#include <utility>

#include "silt/core/error.h"
#include "silt/sim/light_cache.h"

namespace silt::sim {

namespace {

// The light of fewer samples is computed in a second or so.
constexpr std::size_t kFewSamples = 20'000;

std::optional<std::filesystem::path> CacheFile(const Scene& scene, const LightingOptions& options) {
  return options.cache ? LightCacheFile(scene, options) : std::nullopt;
}

BakedLight SolveOrRead(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                       std::optional<std::filesystem::path> file, const LightingOptions& options) {
  if (grid.samples().size() < kFewSamples) file.reset();
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
    : Irradiance(scene, tracer,
                 std::async(std::launch::deferred,
                            [&] { return SurfaceGrid(scene.mesh, options.direct_spacing_m); }),
                 options) {}

// What names the light is computed while the grid is laid.
Irradiance::Irradiance(const Scene& scene, const RayTracer& tracer, std::future<SurfaceGrid> grid,
                       const LightingOptions& options)
    : Irradiance(scene, tracer, std::move(grid), options, CacheFile(scene, options)) {}

Irradiance::Irradiance(const Scene& scene, const RayTracer& tracer, std::future<SurfaceGrid> grid,
                       const LightingOptions& options,
                       const std::optional<std::filesystem::path>& file)
    : grid_(grid.get()), light_(SolveOrRead(scene, tracer, grid_, file, options)) {}

}  // namespace silt::sim
