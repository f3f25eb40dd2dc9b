// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lit_scene.h"

#include <gtest/gtest.h>

#include "scene_builder.h"

namespace silt::sim {
namespace {

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
