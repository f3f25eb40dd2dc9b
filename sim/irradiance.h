// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <future>
#include <optional>

#include "silt/sim/light_solver.h"
#include "silt/sim/lighting_options.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// The light that falls on every surface of a scene, computed once (see SolveLight) or read back
// from the cache.
class Irradiance {
 public:
  Irradiance(const Scene& scene, const RayTracer& tracer, const LightingOptions& options);
  // With SurfaceGrid(scene.mesh, options.direct_spacing_m), which may be on its way.
  Irradiance(const Scene& scene, const RayTracer& tracer, std::future<SurfaceGrid> grid,
             const LightingOptions& options);

  // ∫ L cos θ dω at a point of a triangle, on its front (counter-clockwise) or back.
  Vec3f At(std::uint32_t triangle, float u, float v, bool front) const {
    if (const auto fine = light_.fine.At(grid_.CellAt(triangle, u, v), front)) return *fine;
    return light_.samples.At(grid_.Locate(triangle, u, v), front);
  }

  const SurfaceGrid& grid() const { return grid_; }
  const StoredLight& at_samples() const { return light_.samples; }
  const FineLight& fine() const { return light_.fine; }

 private:
  // Kept in that file, or read from it, where there is one.
  Irradiance(const Scene& scene, const RayTracer& tracer, std::future<SurfaceGrid> grid,
             const LightingOptions& options, const std::optional<std::filesystem::path>& file);

  SurfaceGrid grid_;
  BakedLight light_;
};

}  // namespace silt::sim
