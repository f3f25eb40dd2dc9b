// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lit_scene.h"

#include <cmath>
#include <utility>

namespace silt::sim {

namespace {

// √(area in texels / area in m²), as log2.
float Log2TexelsPerMetre(const Scene& scene, const Triangle& triangle) {
  const int index = scene.materials[triangle.material].texture;
  if (index < 0) return 0;
  const Texture& texture = scene.textures[std::size_t(index)];
  const std::uint32_t* v = triangle.vertex;
  const std::vector<Vec3f>& p = scene.mesh.positions;
  const std::vector<Vec2f>& t = scene.mesh.texcoords;
  const Vec2f e = t[v[1]] - t[v[0]], f = t[v[2]] - t[v[0]];
  const float texels =
      std::abs(e.x * f.y - e.y * f.x) * float(texture.width()) * float(texture.height());
  const float area = Norm(Cross(p[v[1]] - p[v[0]], p[v[2]] - p[v[0]]));
  return texels > 0 && area > 0 ? 0.5f * std::log2(texels / area) : 0;
}

}  // namespace

LitScene::LitScene(Scene scene, const LightingOptions& options)
    : scene_(std::move(scene)),
      tracer_(scene_),
      light_(options.mode),
      path_tracer_(scene_, tracer_),
      planes_(SurfacePlanes(scene_)) {
  if (light_ == LightMode::kBaked) irradiance_.emplace(scene_, tracer_, options);
  for (const Triangle& triangle : scene_.mesh.triangles) {
    texel_density_.push_back(Log2TexelsPerMetre(scene_, triangle));
  }
}

}  // namespace silt::sim
