// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/vector.h"

namespace silt::sim {

// A matt surface that may also shine and reflect. A texture multiplies both `diffuse` and
// `emission`, so that a screen is a white emission under the picture that it shows.
struct Material {
  std::string name;
  Vec3f diffuse{0.5f, 0.5f, 0.5f};  // linear reflectance
  int texture = -1;                 // index into Scene::textures; -1: none
  Vec3f emission;                   // linear radiance
  bool cutout = false;              // the surface is absent where the texture's alpha is below ½
  bool two_sided = true;            // false: the back neither reflects nor emits, it is black

  // Reflection, seen in path-traced light and with LightingOptions::specular only: elsewhere a
  // surface is matt and its colour is `diffuse`. A smooth coat of GGX microfacets over the matt
  // ground reflects `specular` at normal incidence (0.04: varnish, plastic; 0: no coat); a metal
  // has no ground and reflects `diffuse`; `metallic` blends the two.
  float specular = 0;      // in [0, 1]
  float metallic = 0;      // in [0, 1]
  float roughness = 0.5f;  // in [0, 1]; the slopes' scale is α = roughness²
  bool mirror = false;     // perfect, tinted by `diffuse`; the three above do not count

  bool reflects() const { return mirror || specular > 0 || metallic > 0; }
};

}  // namespace silt::sim
