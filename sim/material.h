// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/core/vector.h"

namespace silt::sim {

// A Lambertian surface that may also shine. A texture multiplies both `diffuse` and `emission`, so
// that a screen is a white emission under the picture that it shows.
struct Material {
  std::string name;
  Vec3f diffuse{0.5f, 0.5f, 0.5f};  // linear reflectance
  int texture = -1;                 // index into Scene::textures; -1: none
  Vec3f emission;                   // linear radiance
  bool cutout = false;              // the surface is absent where the texture's alpha is below ½
  bool two_sided = true;            // false: the back neither reflects nor emits, it is black
};

}  // namespace silt::sim
