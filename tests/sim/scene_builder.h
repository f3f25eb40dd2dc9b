// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/sim/scene.h"

namespace silt::sim {

// Small scenes made in code, whose pictures and light are known by formula.
class SceneBuilder {
 public:
  int AddMaterial(const Vec3f& diffuse, const Vec3f& emission = {});
  int AddMaterial(const Material& material);
  // Corner and edges; the front is the side of u × v. Texture coordinates run along u and v.
  void AddQuad(const Vec3f& corner, const Vec3f& u, const Vec3f& v, int material);
  void AddBox(const Vec3f& low, const Vec3f& high, int material);
  // Smooth normals on `segments` × `segments` / 2 quadrilaterals, inscribed.
  void AddSphere(const Vec3f& center, float radius, int segments, int material);
  // With its visible geometry.
  void AddLight(const Vec3f& center, const Vec3f& half_u, const Vec3f& half_v,
                const Vec3f& radiance);

  Scene scene;

 private:
  std::uint32_t AddVertex(const Vec3f& position, const Vec3f& normal, const Vec2f& texcoord);
};

// A room with a light, a box on the floor and a ball: all that a renderer must cope with.
Scene RoomWithBoxAndBall();

}  // namespace silt::sim
