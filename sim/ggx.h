// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/vector.h"

namespace silt::sim {

// Microfacets with the distribution of Trowbridge and Reitz (GGX) and Smith's masking, isotropic.
// Directions are unit, in a frame whose z is the surface's normal, and point away from it.
class Ggx {
 public:
  // The slopes' scale; not below kSmoothest, where float has no more to tell.
  explicit Ggx(float alpha);
  static constexpr float kSmoothest = 2e-3f;

  // D(h) = α² / (π ((h_z)² (α² − 1) + 1)²) per steradian.
  float Distribution(const Vec3f& half) const;
  // G₁ = 1 / (1 + Λ), and G₂ = 1 / (1 + Λ_o + Λ_i): heights correlate.
  float Masking(const Vec3f& w) const { return 1 / (1 + Lambda(w)); }
  float Shadowing(const Vec3f& out, const Vec3f& in) const {
    return 1 / (1 + Lambda(out) + Lambda(in));
  }
  // A facet as seen from `out` (Heitz 2018), of density G₁(o) max(0, o·h) D(h) / o_z.
  Vec3f DrawVisible(const Vec3f& out, const Vec2f& random) const;

 private:
  float Lambda(const Vec3f& w) const;

  float alpha_;
};

// Schlick's reflectance of a facet that is met at cos θ.
Vec3f Schlick(const Vec3f& at_normal, float cosine);

// What a white sky's light becomes on GGX facets with Schlick's reflectance F₀ + (1 − F₀)(1 − c)⁵:
// ∫ f cos θ dω = F₀ · scale + offset, once reflected. By quadrature, tabulated over cos θ and √α;
// good to 3e-3.
struct GgxAlbedo {
  float scale = 1, offset = 0;
  Vec3f Of(const Vec3f& f0) const {
    return {f0.x * scale + offset, f0.y * scale + offset, f0.z * scale + offset};
  }
};
GgxAlbedo DirectionalAlbedo(float cosine, float alpha);
// Its mean over directions: 2 ∫ (·) c dc.
GgxAlbedo MeanAlbedo(float alpha);

}  // namespace silt::sim
