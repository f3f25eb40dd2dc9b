// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_colors.h"

#include <gtest/gtest.h>

#include <numbers>

#include "scene_builder.h"

namespace silt::sim {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

StoredLight Even(const SurfaceGrid& grid, float irradiance) {
  StoredLight light(grid.samples().size());
  for (const bool front : {true, false}) {
    for (Vec3f& e : light.side(front)) e = {irradiance, irradiance, irradiance};
  }
  return light;
}

TEST(SurfaceColors, ReflectAndEmit) {
  SceneBuilder builder;
  Material one_sided;
  one_sided.diffuse = {0.5f, 0.25f, 0};
  one_sided.emission = {0, 0, 3};
  one_sided.two_sided = false;
  builder.AddQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(one_sided));
  const SurfaceGrid grid(builder.scene.mesh, 0.5f);
  const StoredLight sent = SurfaceColors(builder.scene, grid, 0.5f).Radiance(Even(grid, 2 * kPi));
  EXPECT_NEAR(sent.front[0].x, 1, 1e-5f);
  EXPECT_NEAR(sent.front[0].y, 0.5f, 1e-5f);
  EXPECT_EQ(sent.front[0].z, 3);
  EXPECT_EQ(sent.back[0].x, 0);
}

// The linear mean of a checkerboard far finer than the grid; halves much wider stay apart.
TEST(SurfaceColors, TexturesAreBlurredToTheGrid) {
  SceneBuilder builder;
  Image<Rgba8> checkers(64, 64, {255, 255, 255, 255}), halves = checkers;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if ((x + y) % 2) checkers(x, y) = {0, 0, 0, 255};
      if (x < 32) halves(x, y) = {0, 0, 0, 255};
    }
  }
  builder.scene.textures.emplace_back(checkers);
  builder.scene.textures.emplace_back(halves);
  for (const int texture : {0, 1}) {
    Material material;
    material.diffuse = {1, 0.5f, 0};
    material.texture = texture;
    builder.AddQuad({4.0f * float(texture), 0, 0}, {1, 0, 0}, {0, 1, 0},
                    builder.AddMaterial(material));
  }
  const SurfaceGrid grid(builder.scene.mesh, 0.1f);
  const StoredLight sent = SurfaceColors(builder.scene, grid, 0.1f).Radiance(Even(grid, kPi));
  EXPECT_NEAR(sent.At(grid.Locate(0, 0.3f, 0.3f), true).x, 0.5f, 5e-3f);
  EXPECT_NEAR(sent.At(grid.Locate(0, 0.3f, 0.3f), true).y, 0.25f, 5e-3f);
  EXPECT_LT(sent.At(grid.Locate(2, 0, 0.2f), true).x, 0.1f);     // x = 0.2
  EXPECT_GT(sent.At(grid.Locate(2, 0.6f, 0.2f), true).x, 0.9f);  // x = 0.8
}

TEST(SurfaceColors, TheLightOfRectanglesIsLeftOut) {
  SceneBuilder builder;
  builder.AddLight({1, 2, 3}, {0, 0.4f, 0.1f}, {0.6f, 0.2f, 0}, {6, 6, 6});
  builder.AddQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(Vec3f{}, {1, 1, 1}));
  EXPECT_EQ(LightOfTriangle(builder.scene), (std::vector<int>{0, 0, -1, -1}));
  const SurfaceGrid grid(builder.scene.mesh, 10);
  const StoredLight sent = SurfaceColors(builder.scene, grid, 10).Radiance(Even(grid, 1));
  EXPECT_EQ(sent.At(grid.Locate(0, 0.3f, 0.3f), true).x, 0);
  EXPECT_EQ(sent.At(grid.Locate(2, 0.3f, 0.3f), true).x, 1);
}

}  // namespace
}  // namespace silt::sim
