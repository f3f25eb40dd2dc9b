// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/photo_consistency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  const auto median = [&](const TrueView& view) {
    std::vector<double> d = CompareDepths(*world.scene, renderer.options().camera, view, other);
    EXPECT_GT(d.size(), 5000u);
    std::nth_element(d.begin(), d.begin() + std::ptrdiff_t(d.size() / 2), d.end());
    return d[d.size() / 2];
  };
  EXPECT_LT(median(onto), 1e-6);
  TrueView wrong = onto;
  wrong.world_from_camera.translation += Vec3d{3e-4, 3e-4, 3e-4};
  EXPECT_GT(median(wrong), 1e-5);
}

}  // namespace
}  // namespace silt::experiments
