// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "scene_builder.h"

#include <cmath>
#include <numbers>

namespace silt::sim {

int SceneBuilder::AddMaterial(const Material& material) {
  scene.materials.push_back(material);
  return int(scene.materials.size()) - 1;
}

int SceneBuilder::AddMaterial(const Vec3f& diffuse, const Vec3f& emission) {
  Material material;
  material.diffuse = diffuse;
  material.emission = emission;
  return AddMaterial(material);
}

std::uint32_t SceneBuilder::AddVertex(const Vec3f& position, const Vec3f& normal,
                                      const Vec2f& texcoord) {
  scene.mesh.positions.push_back(position);
  scene.mesh.normals.push_back(normal);
  scene.mesh.texcoords.push_back(texcoord);
  return std::uint32_t(scene.mesh.positions.size()) - 1;
}

void SceneBuilder::AddQuad(const Vec3f& corner, const Vec3f& u, const Vec3f& v, int material) {
  const Vec3f normal = Normalized(Cross(u, v));
  const std::uint32_t a = AddVertex(corner, normal, {0, 0});
  const std::uint32_t b = AddVertex(corner + u, normal, {1, 0});
  const std::uint32_t c = AddVertex(corner + u + v, normal, {1, 1});
  const std::uint32_t d = AddVertex(corner + v, normal, {0, 1});
  scene.mesh.triangles.push_back({{a, b, c}, std::uint32_t(material)});
  scene.mesh.triangles.push_back({{a, c, d}, std::uint32_t(material)});
}

void SceneBuilder::AddBox(const Vec3f& low, const Vec3f& high, int material) {
  const Vec3f x{high.x - low.x, 0, 0}, y{0, high.y - low.y, 0}, z{0, 0, high.z - low.z};
  AddQuad(low, y, x, material);
  AddQuad(low + z, x, y, material);
  AddQuad(low, x, z, material);
  AddQuad(low + y, z, x, material);
  AddQuad(low, z, y, material);
  AddQuad(low + x, y, z, material);
}

void SceneBuilder::AddSphere(const Vec3f& center, float radius, int segments, int material) {
  const int rings = segments / 2;
  const auto first = std::uint32_t(scene.mesh.positions.size());
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j <= segments; ++j) {
      const double polar = std::numbers::pi * i / rings,
                   around = 2 * std::numbers::pi * (j % segments) / segments;
      const double ring = i == rings ? 0 : std::sin(polar);  // the pole is one point
      const Vec3f normal =
          Vec3d{ring * std::cos(around), ring * std::sin(around), std::cos(polar)}.Cast<float>();
      AddVertex(center + radius * normal, normal,
                {float(j) / float(segments), 1 - float(i) / float(rings)});
    }
  }
  const auto at = [&](int i, int j) { return first + std::uint32_t(i * (segments + 1) + j); };
  const auto m = std::uint32_t(material);
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < segments; ++j) {
      if (i > 0) scene.mesh.triangles.push_back({{at(i, j), at(i + 1, j), at(i, j + 1)}, m});
      if (i + 1 < rings) {
        scene.mesh.triangles.push_back({{at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)}, m});
      }
    }
  }
}

void SceneBuilder::AddLight(const Vec3f& center, const Vec3f& half_u, const Vec3f& half_v,
                            const Vec3f& radiance) {
  Material material;
  material.diffuse = {};
  material.emission = radiance;
  material.two_sided = false;
  scene.lights.push_back({center, half_u, half_v, radiance});
  AddQuad(center - half_u - half_v, 2.0f * half_u, 2.0f * half_v, AddMaterial(material));
}

Scene RoomWithBoxAndBall() {
  SceneBuilder builder;
  const int white = builder.AddMaterial({0.8f, 0.8f, 0.8f});
  const int red = builder.AddMaterial({0.7f, 0.1f, 0.1f});
  const int blue = builder.AddMaterial({0.1f, 0.2f, 0.7f});
  builder.AddQuad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, white);
  builder.AddQuad({-2, 2, 0}, {4, 0, 0}, {0, 0, 2.5f}, white);
  builder.AddQuad({-2, -2, 2.5f}, {0, 4, 0}, {4, 0, 0}, white);
  builder.AddQuad({-2, -2, 0}, {0, 4, 0}, {0, 0, 2.5f}, red);
  builder.AddQuad({2, -2, 0}, {0, 4, 0}, {0, 0, 2.5f}, blue);
  builder.AddBox({-0.9f, 0.2f, 0}, {-0.3f, 0.8f, 0.9f}, white);
  builder.AddSphere({0.6f, 0.3f, 0.4f}, 0.4f, 32, white);
  builder.AddLight({0, 0, 2.45f}, {0, 0.4f, 0}, {0.6f, 0, 0}, {6, 6, 6});
  builder.scene.ambient = {0.2f, 0.2f, 0.2f};
  return builder.scene;
}

}  // namespace silt::sim
