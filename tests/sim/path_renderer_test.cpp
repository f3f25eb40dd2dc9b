// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_renderer.h"

#include <gtest/gtest.h>

#include "scene_builder.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

void Fill(int k, int left, int top, RayPacket& rays) {
  const float jitter = float(k % 4) / 4;
  for (int i = 0; i < kPacketSize; ++i) {
    const float x = float(left + i % 4) + jitter, y = float(top + i / 4);
    rays.Set(i, {{0, -1.9f, 1.2f}, {x / 12 - 0.5f, 1, 0.4f - y / 10}});
  }
}

Image<Vec3f> Render(const PathPicture& picture) {
  static const Scene scene = RoomWithBoxAndBall();
  static const RayTracer rays(scene);
  return RenderPaths(PathTracer(scene, rays), picture, Fill);
}

bool Same(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (Norm(a.data()[i] - b.data()[i]) != 0) return false;
  }
  return true;
}

TEST(PathRenderer, DoesNotDependOnTheNumberOfThreads) {
  SetThreadCount(1);
  const Image<Vec3f> one = Render({12, 9, 20});
  SetThreadCount(3);
  const Image<Vec3f> three = Render({12, 9, 20});
  SetThreadCount(0);
  EXPECT_TRUE(Same(one, three));
}

TEST(PathRenderer, SeedsAndFramesGiveOtherNoise) {
  const Image<Vec3f> a = Render({12, 9, 4, 1, 0});
  EXPECT_FALSE(Same(a, Render({12, 9, 4, 2, 0})));
  EXPECT_FALSE(Same(a, Render({12, 9, 4, 1, 1})));
}

// Pixels are unbiased at any number of samples: 4 against 256 per pixel, over the picture, 2 %.
TEST(PathRenderer, MoreSamplesOnlyTakeNoiseAway) {
  const auto mean = [](const Image<Vec3f>& image) {
    double sum = 0;
    for (const Vec3f& v : image) sum += v.x / double(image.size());
    return sum;
  };
  EXPECT_NEAR(mean(Render({48, 36, 4})) / mean(Render({48, 36, 64})), 1, 0.02);
}

}  // namespace
}  // namespace silt::sim
