// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/keyframe_features.h"

#include <gtest/gtest.h>

#include "textured_planes.h"

namespace silt::tracker {
namespace {

TEST(KeyframeFeatures, HavePointsWhereDepthIsMeasured) {
  View view = ViewOfPlanes(kIclNuimCamera, {});
  for (int y = 0; y < 480; ++y) {
    for (int x = 320; x < 640; ++x) view.depth_m(x, y) = 0;
  }
  const KeyframeFeatures features(KeyframeOf(view), kIclNuimCamera, {}, 1);
  ASSERT_EQ(features.points.size(), features.features.size());
  int measured = 0;
  for (std::size_t i = 0; i < features.points.size(); ++i) {
    const Vec2d& pixel = features.features[i].pixel;
    if (pixel.x > 319) {
      EXPECT_FALSE(features.points[i]);
    }
    if (!features.points[i]) continue;
    ++measured;
    EXPECT_NEAR(kIclNuimCamera.Project(*features.points[i]).x, pixel.x, 1e-9);
  }
  EXPECT_GT(measured, 50);
}

TEST(KeyframeFeatureCache, ComputesOnceAndForgetsTheLeastRecentlyUsed) {
  const View view = ViewOfPlanes(kIclNuimCamera, {}), blank{Image<float>(640, 480), {}};
  KeyframeFeatureCache cache(2);
  const auto count = [&](const View& of, int id) {
    return cache.Get(KeyframeOf(of, id), kIclNuimCamera, {}, 1).features.size();
  };
  const std::size_t found = count(view, 0);
  ASSERT_GT(found, 0u);
  EXPECT_EQ(count(blank, 0), found);  // taken from the cache: the image is not looked at
  EXPECT_EQ(count(blank, 1), 0u);
  EXPECT_EQ(count(blank, 0), found);
  EXPECT_EQ(count(blank, 2), 0u);  // 1 goes, being used longest ago
  EXPECT_EQ(cache.size(), 2);
  EXPECT_EQ(count(blank, 0), found);
  EXPECT_EQ(count(view, 1), found);
}

}  // namespace
}  // namespace silt::tracker
