// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_colors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/core/parallel.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/shading.h"

namespace silt::sim {

namespace {

constexpr std::size_t kBlock = 4096;

bool IsInside(const RectLight& light, const Vec3f& point) {
  const Vec3f way = point - light.center;
  const float u_sq = Dot(light.half_u, light.half_u), v_sq = Dot(light.half_v, light.half_v);
  // The two half edges need not be at right angles.
  const float uv = Dot(light.half_u, light.half_v), det = u_sq * v_sq - uv * uv;
  const float a = Dot(way, light.half_u), b = Dot(way, light.half_v);
  const float s = (a * v_sq - b * uv) / det, t = (b * u_sq - a * uv) / det;
  const Vec3f off = way - s * light.half_u - t * light.half_v;
  constexpr float slack = 1e-3f;
  return std::abs(s) < 1 + slack && std::abs(t) < 1 + slack && Norm(off) < slack;
}

}  // namespace

std::vector<int> LightOfTriangle(const Scene& scene) {
  const Mesh& mesh = scene.mesh;
  std::vector<int> light_of(mesh.triangles.size(), -1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    const Material& material = scene.materials[triangle.material];
    if (material.two_sided || Norm(material.emission) == 0) continue;
    const auto found =
        std::find_if(scene.lights.begin(), scene.lights.end(), [&](const RectLight& l) {
          return std::all_of(std::begin(triangle.vertex), std::end(triangle.vertex),
                             [&](std::uint32_t v) { return IsInside(l, mesh.positions[v]); });
        });
    if (found != scene.lights.end()) light_of[i] = int(found - scene.lights.begin());
  }
  return light_of;
}

SurfaceColors::SurfaceColors(const Scene& scene, const SurfaceGrid& grid, float spacing_m)
    : colors_(grid.samples().size()) {
  const std::vector<int> light_of = LightOfTriangle(scene);
  const float log2_spacing = std::log2(spacing_m);
  ParallelFor(int((colors_.size() + kBlock - 1) / kBlock), [&](int block) {
    const std::size_t first = std::size_t(block) * kBlock;
    for (std::size_t i = first; i < std::min(colors_.size(), first + kBlock); ++i) {
      const SurfaceGrid::Origin& origin = grid.origins()[i];
      const Triangle& triangle = scene.mesh.triangles[origin.triangle];
      const Material& material = scene.materials[triangle.material];
      colors_[i] = {material.diffuse, material.emission, material.two_sided};
      if (light_of[origin.triangle] >= 0) colors_[i].emission = {};
      if (material.texture < 0) continue;
      const Texture& texture = scene.textures[std::size_t(material.texture)];
      const Vec2f uv = TexcoordAt(scene.mesh, triangle, origin.u, origin.v);
      const Vec3f texel = texture.Sample(
          uv.x, uv.y, Log2TexelsPerMetre(scene.mesh, triangle, texture) + log2_spacing);
      colors_[i].albedo = colors_[i].albedo * texel;
      colors_[i].emission = colors_[i].emission * texel;
    }
  });
}

StoredLight SurfaceColors::Radiance(const StoredLight& irradiance) const {
  StoredLight radiance(colors_.size());
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const Color& c = colors_[i];
    const Vec3f share = std::numbers::inv_pi_v<float> * c.albedo;
    radiance.front[i] = c.emission + share * irradiance.front[i];
    if (c.two_sided) radiance.back[i] = c.emission + share * irradiance.back[i];
  }
  return radiance;
}

}  // namespace silt::sim
