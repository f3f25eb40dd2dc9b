// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/photo_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "silt/sim/primitives.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

constexpr PinholeCamera kCamera{100, 100, 39.5, 29.5, 80, 60};

// A plane at z = 2 in the world with waves of brightness, seen by a camera that looks along z.
TrueView WavesFrom(const Vec3d& position) {
  TrueView view{Image<float>(80, 60), Image<float>(80, 60), {}};
  view.world_from_camera.translation = position;
  const double z = 2 - position.z;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      const Vec3d p = view.world_from_camera * kCamera.Unproject(x, y, z);
      view.luma(x, y) = float(128 + 20 * std::sin(5 * p.x) * std::cos(4 * p.y));
      view.depth_m(x, y) = float(z);
    }
  }
  return view;
}

float Largest(const std::vector<float>& values) {
  return *std::max_element(values.begin(), values.end());
}

TEST(PhotoConsistency, ViewsOfOneWorldAgree) {
  const PhotoDifferences d =
      ComparePictures(kCamera, WavesFrom({0, 0, 0}), WavesFrom({0.05, 0.02, -0.1}));
  EXPECT_GT(d.all.size(), 3000u);
  EXPECT_GT(d.at_gradients.size(), 1000u);
  EXPECT_LT(d.at_gradients.size(), d.all.size());
  EXPECT_LT(Largest(d.all), 0.01f);
}

TEST(PhotoConsistency, AWrongPoseOrDepthShows) {
  const TrueView onto = WavesFrom({0, 0, 0});
  TrueView moved = WavesFrom({0.05, 0.02, 0});
  moved.world_from_camera.translation.x += 0.01;  // half a pixel
  EXPECT_GT(Largest(ComparePictures(kCamera, onto, moved).all), 0.3f);
  TrueView deeper = onto;
  for (float& z : deeper.depth_m) z *= 1.01f;
  EXPECT_GT(Largest(ComparePictures(kCamera, deeper, WavesFrom({0.3, 0, 0})).all), 0.1f);
}

TEST(PhotoConsistency, WhatIsHiddenOrOutsideIsLeftOut) {
  const TrueView onto = WavesFrom({0, 0, 0});
  TrueView covered = WavesFrom({0, 0, 0});
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 40; ++x) covered.depth_m(x, y) = 1;
  }
  const PhotoDifferences d = ComparePictures(kCamera, onto, covered);
  EXPECT_GT(d.hidden, 38u * 58);
  EXPECT_LT(d.all.size(), 40u * 58);
  const PhotoDifferences away = ComparePictures(kCamera, onto, WavesFrom({5, 0, 0}));
  EXPECT_TRUE(away.all.empty());
}

TEST(PhotoConsistency, DepthsAgreeUnlessAPoseIsWrong) {
  const World& world = StudioWorld();
  const sim::Renderer renderer(world.scene, SmallPictures(160));
  const SE3d pose = world.path.WorldFromCamera(0.5), other = world.path.WorldFromCamera(0.8);
  const TrueView onto{{}, renderer.RenderDepth(pose), pose};
  const auto largest_and_median = [&](const TrueView& view) {
    std::vector<double> d = CompareDepths(*world.scene, renderer.options().camera, view, other).m;
    EXPECT_GT(d.size(), 10000u);
    std::sort(d.begin(), d.end());
    return std::pair{d.back(), d[d.size() / 2]};
  };
  EXPECT_LT(largest_and_median(onto).first, 1e-5);
  EXPECT_LT(largest_and_median(onto).second, 1e-6);
  TrueView wrong = onto;
  wrong.world_from_camera.translation += Vec3d{3e-4, 3e-4, 3e-4};
  EXPECT_GT(largest_and_median(wrong).second, 1e-5);
  // However wrong a depth is, it is told as long as the same triangle is seen there.
  wrong = onto;
  for (float& z : wrong.depth_m) z *= 1.02f;
  EXPECT_GT(largest_and_median(wrong).first, 0.01);
}

// A plate half a millimetre before a wall: what it hides is hidden, and no difference in depth.
// Seen from the left through a long lens, half a millimetre of the wall lies beside the plate's
// edge that it hides from the right.
TEST(PhotoConsistency, WhatIsCloseBeforeASurfaceHidesIt) {
  sim::Scene scene;
  scene.ambient = {1, 1, 1};
  scene.materials.push_back({});
  sim::AppendQuad(scene.mesh, {-5, -5, 2}, {10, 0, 0}, {0, 10, 0}, {0, {}});
  sim::AppendQuad(scene.mesh, {0, -5, 1.9995}, {5, 0, 0}, {0, 10, 0}, {0, {}});
  scene.instances = {{"wall", 0, 2}, {"plate", 2, 2}};
  sim::LightingOptions lighting;
  lighting.mode = sim::LightMode::kPath;
  const auto lit = std::make_shared<const sim::LitScene>(scene, lighting);
  SE3d left, right;
  left.translation.x = -1;
  right.translation.x = 1;
  sim::RenderOptions options;
  options.camera = {2e5, 2e5, 100 - 1e5, 9.5, 200, 20};  // a hundredth of a millimetre a pixel
  const TrueView onto{{}, sim::Renderer(lit, options).RenderDepth(left), left};
  const DepthDifferences d = CompareDepths(*lit, options.camera, onto, right);
  EXPECT_NEAR(double(d.hidden), 50 * 20, 4 * 20);
  EXPECT_GT(d.m.size(), 2000u);
  EXPECT_LT(*std::max_element(d.m.begin(), d.m.end()), 1e-5);
}

}  // namespace
}  // namespace silt::experiments
