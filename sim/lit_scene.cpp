// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lit_scene.h"

#include <utility>

namespace silt::sim {

namespace {

std::future<SurfaceGrid> StartGrid(const Scene& scene, const LightingOptions& options) {
  if (options.mode != LightMode::kBaked) return {};
  return std::async(std::launch::async, [&scene, spacing_m = options.direct_spacing_m] {
    return SurfaceGrid(scene.mesh, spacing_m);
  });
}

}  // namespace

LitScene::LitScene(Scene scene, const LightingOptions& options)
    : scene_(std::move(scene)),
      grid_(StartGrid(scene_, options)),
      tracer_(scene_),
      light_(options.mode),
      path_tracer_(scene_, tracer_),
      planes_(SurfacePlanes(scene_)) {
  if (light_ != LightMode::kBaked) return;
  irradiance_.emplace(scene_, tracer_, std::move(grid_), options);
  shading_.emplace(scene_, *irradiance_);
  if (options.specular) reflection_.emplace(scene_, tracer_, *irradiance_);
}

}  // namespace silt::sim
