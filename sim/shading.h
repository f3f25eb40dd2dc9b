// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/lit_scene.h"

namespace silt::sim {

struct SurfaceHit {
  std::uint32_t triangle;
  float u, v;
  float cosine;       // of the angle from the ray to the front normal
  float footprint_m;  // width of the ray's cone at the hit, across the ray
};

// Radiance towards the viewer: emission + albedo/π · irradiance on the side that is seen. It
// depends on where the viewer stands only through the blur of textures.
Vec3f Shade(const LitScene& lit, const SurfaceHit& hit);

}  // namespace silt::sim
