// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/scene.h"
#include "silt/sim/stored_light.h"

namespace silt::sim {

// What the samples of a grid reflect and send by themselves, where light is followed from surface
// to surface: textures blurred to about the width of the grid, the rectangles' light left out,
// which is counted apart.
class SurfaceColors {
 public:
  SurfaceColors(const Scene& scene, const SurfaceGrid& grid, float spacing_m);

  // B = emission + albedo/π · E at every sample, on both sides.
  StoredLight Radiance(const StoredLight& irradiance) const;

 private:
  struct Color {
    Vec3f albedo, emission;
    bool two_sided = true;
  };
  std::vector<Color> colors_;  // by sample
};

// For each triangle of the mesh, the rectangular light that it is part of, or −1.
std::vector<int> LightOfTriangle(const Scene& scene);

}  // namespace silt::sim
