// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene_builder.h"
#include "silt/sim/lit_scene.h"

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

// On a surface at z = const, coming along x.
SurfaceHit Hit(std::uint32_t triangle, float cosine, float footprint_m = 1e-4f) {
  return {triangle, 0.2f, 0.3f, cosine, footprint_m, {std::sqrt(1 - cosine * cosine), 0, cosine}};
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

TEST(Shading, TexelDensityIsTheMeanOfBothDirections) {
  SceneBuilder builder;
  const Texture texture(Image<Rgba8>(64, 16));
  // 64 texels on 2 m and 16 on 0.5 m: 32 per metre both ways.
  builder.AddQuad({0, 0, 0}, {2, 0, 0}, {0, 0.5f, 0}, 0);
  // 64 on 1 m and 16 on 1 m: √(64·16) = 32.
  builder.AddQuad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 0);
  for (const Triangle& triangle : builder.scene.mesh.triangles) {
    EXPECT_NEAR(Log2TexelsPerMetre(builder.scene.mesh, triangle, texture), 5, 1e-5f);
  }
  builder.AddQuad({0, 0, 1}, {1, 0, 0}, {2, 0, 0}, 0);  // without area
  EXPECT_EQ(Log2TexelsPerMetre(builder.scene.mesh, builder.scene.mesh.triangles[4], texture), 0);
}

// The stripes: black for x < ½ and white beyond.
LitScene Stripes() {
  Material material;
  material.diffuse = {1, 1, 1};
  material.texture = 0;
  return LitScene(Samples({material}));
}

// On the stripes, so many texels behind their edge.
SurfaceHit NearEdge(float texels, float cosine, float footprint_m) {
  SurfaceHit hit = Hit(0, cosine, footprint_m);
  hit.v = 0.2f;
  hit.u = 0.5f + texels / 64 - hit.v;  // x = u + v
  return hit;
}

TEST(Shading, WideConesSeeTheMeanOfTheTexture) {
  EXPECT_NEAR(Shade(Stripes(), Hit(0, -1, 1)).x, 0.5f, 5e-3f);
}

// The share of a slanted cone's long footprint that lies beyond the edge, when it runs across the
// stripes; all or nothing when it runs along them.
TEST(Shading, SlantedConesAverageAlongTheirFootprint) {
  const LitScene lit = Stripes();
  for (const float texels : {-6.0f, -3.0f, 0.0f, 3.0f, 6.0f}) {
    SurfaceHit hit = NearEdge(texels, -0.1f, 1.0f / 64);  // 10 texels long
    EXPECT_NEAR(Shade(lit, hit).x, std::clamp(0.5f + texels / 10, 0.0f, 1.0f), 0.06f) << texels;
    hit.direction = {0, hit.direction.x, hit.direction.z};
    EXPECT_NEAR(Shade(lit, hit).x, texels < 0 ? 0 : texels > 0 ? 1 : 0.5f, 0.01f) << texels;
  }
}

// At the limits between numbers of probes there are no steps to be seen.
TEST(Shading, ALongerFootprintChangesTheColourLittleByLittle) {
  const LitScene lit = Stripes();
  float before = -1;
  for (float cosine = 1; cosine > 0.07f; cosine *= 0.995f) {
    const float now = Shade(lit, NearEdge(1.5f, -cosine, 1.0f / 32)).x;
    if (before >= 0) {
      EXPECT_NEAR(now, before, 0.1f) << cosine;
    }
    before = now;
  }
}

// Of stored light, fine cells and others, on both sides: what Irradiance tells.
TEST(Shading, ShowsTheLightThatIsStored) {
  SceneBuilder builder;
  const int gray = builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
  builder.AddQuad({0, 0, 0}, {0.5f, 0, 0}, {0, 0.5f, 0}, gray);
  for (const float y : {0.1f, 0.2f, 0.3f, 0.4f}) {
    builder.AddBox({0, y, 0.01f}, {0.5f, y + 0.01f, 0.02f}, gray);
  }
  builder.AddLight({0.2f, 0.2f, 1}, {0, 0.1f, 0}, {0.1f, 0, 0}, {50, 50, 50});
  const LitScene lit(builder.scene);
  const Irradiance& irradiance = lit.irradiance();
  int fine = 0, coarse = 0;
  for (int i = 0; i < 900; ++i) {
    SurfaceHit hit = Hit(std::uint32_t(i % 2), i % 4 < 2 ? -1.0f : 1.0f);
    hit.u = float(i % 30) / 30, hit.v = (1 - hit.u) * float(i / 30) / 30;
    const bool front = hit.cosine < 0;
    const Vec3f expected = irradiance.At(hit.triangle, hit.u, hit.v, front);
    EXPECT_NEAR(Shade(lit, hit).y, 0.5f / std::numbers::pi_v<float> * expected.y, 1e-4f) << i;
    ++(irradiance.fine().At(irradiance.grid().CellAt(hit.triangle, hit.u, hit.v), front) ? fine
                                                                                         : coarse);
  }
  EXPECT_GT(fine, 50);
  EXPECT_GT(coarse, 50);
}

}  // namespace
}  // namespace silt::sim
