// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace silt::sim {

namespace {

Vec3f TextureAt(const LitScene& lit, const SurfaceHit& hit, const Triangle& triangle,
                const Texture& texture) {
  const Vec2f uv = TexcoordAt(lit.scene().mesh, triangle, hit.u, hit.v);
  // The cone meets the surface in an ellipse; its geometric mean width is footprint/√cos.
  const float slant = std::max(std::abs(hit.cosine), 1e-3f);
  const float lod = lit.log2_texels_per_metre(hit.triangle) +
                    0.5f * std::log2(hit.footprint_m * hit.footprint_m / slant);
  return texture.Sample(uv.x, uv.y, lod);
}

}  // namespace

Vec3f Shade(const LitScene& lit, const SurfaceHit& hit) {
  const Scene& scene = lit.scene();
  const Triangle& triangle = scene.mesh.triangles[hit.triangle];
  const Material& material = scene.materials[triangle.material];
  const bool front = hit.cosine < 0;
  if (!front && !material.two_sided) return {};
  const Vec3f irradiance = lit.irradiance().At(hit.triangle, hit.u, hit.v, front);
  const Vec3f radiance =
      material.emission + std::numbers::inv_pi_v<float> * (material.diffuse * irradiance);
  if (material.texture < 0) return radiance;
  return radiance * TextureAt(lit, hit, triangle, scene.textures[std::size_t(material.texture)]);
}

}  // namespace silt::sim
