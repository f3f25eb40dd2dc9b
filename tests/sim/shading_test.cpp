// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shading.h"

#include <gtest/gtest.h>

#include "scene_builder.h"

namespace silt::sim {
namespace {

// Quadrilaterals far apart under a white sky, one per material: E = π on both sides.
Scene Samples(const std::vector<Material>& materials) {
  SceneBuilder builder;
  Image<Rgba8> stripes(64, 64, {255, 255, 255, 255});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 32; ++x) stripes(x, y) = {0, 0, 0, 255};
  }
  builder.scene.textures.emplace_back(stripes);
  builder.scene.ambient = {1, 1, 1};
  float x = 0;
  for (const Material& material : materials) {
    builder.AddQuad({x, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(material));
    x += 10;
  }
  return builder.scene;
}

SurfaceHit Hit(std::uint32_t triangle, float cosine, float footprint_m = 1e-4f) {
  return {triangle, 0.2f, 0.3f, cosine, footprint_m};
}

TEST(Shading, IsAlbedoTimesIrradianceOverPiPlusEmission) {
  Material material;
  material.diffuse = {0.5f, 0.25f, 0};
  material.emission = {0, 1, 2};
  const LitScene lit(Samples({material}));
  for (const float cosine : {-1.0f, -0.1f, 0.7f}) {  // front and back alike
    const Vec3f radiance = Shade(lit, Hit(0, cosine));
    EXPECT_NEAR(radiance.x, 0.5f, 1e-4f);
    EXPECT_NEAR(radiance.y, 1.25f, 1e-4f);
    EXPECT_NEAR(radiance.z, 2, 1e-4f);
  }
}

TEST(Shading, TheBackOfAOneSidedSurfaceIsBlack) {
  Material material;
  material.emission = {1, 1, 1};
  material.two_sided = false;
  const LitScene lit(Samples({material}));
  EXPECT_GT(Shade(lit, Hit(0, -0.5f)).x, 1);
  EXPECT_EQ(Shade(lit, Hit(0, 0.5f)).x, 0);
}

TEST(Shading, TexturesMultiplyReflectionAndEmission) {
  Material material;
  material.diffuse = {0.5f, 0.5f, 0.5f};
  material.emission = {1, 0, 0};
  material.texture = 0;
  const LitScene lit(Samples({material}));
  // Triangle 0 is (0,0) (1,0) (1,1): u + v of the hit is its texture's u.
  SurfaceHit dark = Hit(0, -1), bright = Hit(0, -1);
  dark.u = 0.1f, dark.v = 0.1f;
  bright.u = 0.5f, bright.v = 0.3f;
  EXPECT_NEAR(Shade(lit, dark).x, 0, 1e-4f);
  EXPECT_NEAR(Shade(lit, bright).x, 1.5f, 1e-3f);
  EXPECT_NEAR(Shade(lit, bright).y, 0.5f, 1e-3f);
}

// A cone as wide as the texture sees its mean, and a slanted one sooner than a straight one.
TEST(Shading, WideConesSeeTheMeanOfTheTexture) {
  Material material;
  material.diffuse = {1, 1, 1};
  material.texture = 0;
  const LitScene lit(Samples({material}));
  EXPECT_NEAR(Shade(lit, Hit(0, -1, 1)).x, 0.5f, 5e-3f);
  SurfaceHit hit = Hit(0, -1, 1.0f / 16);
  hit.u = 0.4f, hit.v = 0.15f;  // 3 texels from the stripe's edge
  const float straight = Shade(lit, hit).x;
  hit.cosine = -0.04f;
  EXPECT_GT(straight, Shade(lit, hit).x + 0.05f);
}

}  // namespace
}  // namespace silt::sim
