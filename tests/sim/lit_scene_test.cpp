// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lit_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"

namespace silt::sim {
namespace {

TEST(LitScene, TexelDensityIsTheMeanOfBothDirections) {
  SceneBuilder builder;
  builder.scene.textures.emplace_back(Image<Rgba8>(64, 16));
  Material textured;
  textured.texture = 0;
  // 64 texels on 2 m and 16 on 0.5 m: 32 per metre both ways.
  builder.AddQuad({0, 0, 0}, {2, 0, 0}, {0, 0.5f, 0}, builder.AddMaterial(textured));
  // 64 on 1 m and 16 on 1 m: √(64·16) = 32.
  builder.AddQuad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 0);
  builder.AddQuad({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  const LitScene lit(builder.scene);
  for (const std::uint32_t triangle : {0u, 1u, 2u, 3u}) {
    EXPECT_NEAR(lit.log2_texels_per_metre(triangle), 5, 1e-5f);
  }
  EXPECT_EQ(lit.log2_texels_per_metre(4), 0);
}

TEST(LitScene, KeepsASceneOfItsOwn) {
  Scene scene = RoomWithBoxAndBall();
  LightingOptions coarse;
  coarse.direct_spacing_m = coarse.indirect_spacing_m = 1;
  const LitScene lit(scene, coarse);
  const std::size_t triangles = scene.mesh.triangles.size();
  scene = Scene{};
  EXPECT_EQ(lit.scene().mesh.triangles.size(), triangles);
  RayPacket rays;
  rays.Set(0, {{0, 0, 1}, {0, 0, -1}});
  HitPacket hits;
  lit.tracer().Trace(rays, hits);
  EXPECT_LT(hits.triangle[0], triangles);
}

}  // namespace
}  // namespace silt::sim
