// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/vector.h"
#include "silt/sim/material.h"

namespace silt::sim {

// How one point of a surface scatters light. Directions are unit, in a frame whose z is the shading
// normal on the side that is looked at, and point away from the surface; `out` is the viewer's.
//
// A coat of GGX facets with directional albedo R(θ) over a Lambertian ground of reflectance d:
//   f = D G₂ F / (4 cos θ_o cos θ_i) + (d/π) (1 − R(θ_o)) (1 − R(θ_i)) / (1 − mean R)
// reciprocal, and reflecting R(θ_o) + d (1 − R(θ_o)) of a white sky (Kelemen, Szirmay-Kalos 2001).
class Bsdf {
 public:
  // `color`: the material's diffuse colour times its texture. `with_reflection` false: matt.
  Bsdf(const Material& material, const Vec3f& color, bool with_reflection);

  // f cos θ_i; what a perfect mirror reflects is not in it.
  Vec3f Evaluate(const Vec3f& out, const Vec3f& in) const;
  // Of Draw's directions, per steradian.
  float Density(const Vec3f& out, const Vec3f& in) const;

  struct Sample {
    Vec3f in;
    Vec3f weight;       // f cos θ_i / density
    float density = 0;  // 0 for a mirror, whose direction is the only one, and where none was found
    bool mirrored = false;
  };
  Sample Draw(const Vec3f& out, float lobe, const Vec2f& random) const;

  bool is_mirror() const { return mirror_; }
  bool is_glossy() const { return glossy_; }
  // The part of a matt surface's light that leaves through the coat towards `out`.
  Vec3f GroundShare(const Vec3f& out) const;
  // The ground's reflectance towards `out` where light comes from all sides alike.
  Vec3f GroundAlbedo(const Vec3f& out) const;
  // The same Bsdf without its ground.
  Bsdf Reflection() const;

 private:
  float GlossShare(const Vec3f& out) const;  // how often Draw takes the coat
  Vec3f Gloss(const Vec3f& out, const Vec3f& in) const;

  Vec3f ground_, f0_;
  float alpha_ = 1;
  float metallic_ = 0;
  bool glossy_ = false, mirror_ = false;
};

}  // namespace silt::sim
