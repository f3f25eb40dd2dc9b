// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lit_scene.h"

#include <utility>

namespace silt::sim {

LitScene::LitScene(Scene scene, const LightingOptions& options)
    : scene_(std::move(scene)),
      tracer_(scene_),
      light_(options.mode),
      path_tracer_(scene_, tracer_),
      planes_(SurfacePlanes(scene_)) {
  if (light_ != LightMode::kBaked) return;
  irradiance_.emplace(scene_, tracer_, options);
  shading_.emplace(scene_, *irradiance_);
  if (options.specular) reflection_.emplace(scene_, tracer_, *irradiance_);
}

}  // namespace silt::sim
