// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <memory>
#include <optional>

#include "silt/sim/irradiance.h"
#include "silt/sim/lighting_options.h"
#include "silt/sim/path_tracer.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/reflection.h"
#include "silt/sim/scene.h"
#include "silt/sim/shading.h"
#include "silt/sim/surface_planes.h"

namespace silt::sim {

// A scene with all that is computed once for it; renderers of different cameras, shutters and
// noise share one. Throws silt::Error where Embree refuses.
class LitScene {
 public:
  explicit LitScene(Scene scene, const LightingOptions& options = {});
  LitScene(const LitScene&) = delete;  // the tracer and the light refer to this very scene
  LitScene& operator=(const LitScene&) = delete;

  const Scene& scene() const { return scene_; }
  const RayTracer& tracer() const { return tracer_; }
  LightMode light() const { return light_; }
  // Light that is stored on surfaces, and what they send to the eye; only for LightMode::kBaked.
  const Irradiance& irradiance() const { return *irradiance_; }
  const Shading& shading() const { return *shading_; }
  const PathTracer& path_tracer() const { return path_tracer_; }
  // Null unless surfaces are to reflect on top of stored light.
  const Reflection* reflection() const { return reflection_ ? &*reflection_ : nullptr; }
  const SurfacePlane& plane(std::uint32_t triangle) const { return planes_[triangle]; }

 private:
  Scene scene_;
  std::future<SurfaceGrid> grid_;  // of the light, laid while the tracer is built
  RayTracer tracer_;
  LightMode light_;
  PathTracer path_tracer_;
  std::optional<Irradiance> irradiance_;
  std::optional<Reflection> reflection_;
  std::vector<SurfacePlane> planes_;
  std::optional<Shading> shading_;
};

}  // namespace silt::sim
