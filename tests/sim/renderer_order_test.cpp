// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <ostream>

#include "scene_builder.h"
#include "silt/core/parallel.h"
#include "silt/sim/image_tiles.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

// A frame is the same bytes, whichever of its tiles is rendered first and on how many threads.
namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{48.3, 48, 29.5, 21.5, 60, 44};  // no multiple of the tiles

SE3d Moving(double t) {
  return LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7}) * SE3d::Exp({{0.1 * t, 0.2 * t, 0}, {t, 0, 0}});
}

struct Case {
  const char* name;
  LightMode light = LightMode::kBaked;
  bool specular = false;
  PixelPattern pattern = PixelPattern::kShared;
  PixelFilter filter = PixelFilter::kBox;
  double row_time_s = 0;
};
void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

// A varnished room, so that there is something to reflect.
std::shared_ptr<const LitScene> Lit(const Case& each) {
  Scene scene = RoomWithBoxAndBall();
  for (Material& material : scene.materials) {
    if (Norm(material.emission) == 0) material.specular = 0.04f, material.roughness = 0.3f;
  }
  LightingOptions lighting;
  lighting.mode = each.light;
  lighting.specular = each.specular;
  lighting.direct_spacing_m = lighting.bounce_spacing_m = 0.4f;
  lighting.indirect_spacing_m = 1;
  lighting.gather_directions = lighting.bounce_directions = 16;
  lighting.bounces = 2;
  return std::make_shared<const LitScene>(std::move(scene), lighting);
}

struct Picture {
  Image<Vec3f> linear;
  GeometryBuffers geometry;

  bool operator==(const Picture& other) const {
    return std::memcmp(linear.data(), other.linear.data(), linear.size() * sizeof(Vec3f)) == 0 &&
           geometry.depth_m == other.geometry.depth_m &&
           geometry.instance == other.geometry.instance &&
           geometry.material == other.geometry.material;
  }
};

class RendererOrder : public testing::TestWithParam<Case> {
 protected:
  static Picture Rendered(const std::shared_ptr<const LitScene>& lit) {
    RenderOptions options{.camera = kCamera, .filter = GetParam().filter};
    options.pattern = GetParam().pattern;
    options.shutter = {0.1, 4, GetParam().row_time_s};
    options.seed = 5;
    const Renderer renderer(lit, options);
    return {renderer.RenderLinear(Moving, 0.5, 3), renderer.RenderGeometry(Moving, 0.5)};
  }
};

TEST_P(RendererOrder, DoesNotChangeAByte) {
  const auto lit = Lit(GetParam());
  const Picture expected = Rendered(lit);
  for (const int threads : {1, 2, 3}) {
    SetThreadCount(threads);
    EXPECT_TRUE(Rendered(lit) == expected) << threads << " threads";
    {
      const ScopedTileOrder reversed([](int turn, int count) { return count - 1 - turn; });
      EXPECT_TRUE(Rendered(lit) == expected) << "reversed, " << threads << " threads";
    }
    const ScopedTileOrder shuffled([](int turn, int count) {
      EXPECT_EQ(std::gcd(31, count), 1);  // or it would be no permutation
      return (31 * turn + 17) % count;
    });
    EXPECT_TRUE(Rendered(lit) == expected) << "shuffled, " << threads << " threads";
  }
  SetThreadCount(0);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, RendererOrder,
    testing::Values(Case{"Baked"}, Case{"Specular", LightMode::kBaked, true},
                    Case{"Path", LightMode::kPath},
                    Case{"Scrambled", LightMode::kBaked, false, PixelPattern::kScrambled},
                    Case{"ScrambledGaussian", LightMode::kBaked, false, PixelPattern::kScrambled,
                         PixelFilter::kGaussian},
                    Case{"ScrambledRolling", LightMode::kBaked, false, PixelPattern::kScrambled,
                         PixelFilter::kBox, 1e-4},
                    Case{"ScrambledPath", LightMode::kPath, false, PixelPattern::kScrambled}),
    [](const auto& each) { return each.param.name; });

// Light and its reflections are solved and traced on any number of threads.
TEST(RendererThreads, ReflectionDoesNotDependOnTheNumberOfThreads) {
  const Case specular{"Specular", LightMode::kBaked, true};
  const RenderOptions options{.camera = kCamera};
  Image<Vec3f> images[4], matt;
  for (const int threads : {1, 2, 3}) {
    SetThreadCount(threads);
    images[threads] = Renderer(Lit(specular), options).RenderLinear(Moving, 0.5);
  }
  SetThreadCount(0);
  matt = Renderer(Lit({"Matt"}), options).RenderLinear(Moving, 0.5);
  const std::size_t bytes = matt.size() * sizeof(Vec3f);
  EXPECT_EQ(std::memcmp(images[1].data(), images[2].data(), bytes), 0);
  EXPECT_EQ(std::memcmp(images[1].data(), images[3].data(), bytes), 0);
  EXPECT_NE(std::memcmp(images[1].data(), matt.data(), bytes), 0);  // there is some
}

}  // namespace
}  // namespace silt::sim
