// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/path_file.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kSmallCamera{120.3, 120, 79.5, 59.5, 160, 120};

LightingOptions Coarse() { return {.direct_spacing_m = 0.2f, .indirect_spacing_m = 0.5f}; }

PoseAtTime Still(const SE3d& pose) {
  return [pose](double) { return pose; };
}

TEST(Renderer, FramesDoNotDependOnTheNumberOfThreads) {
  const SE3d pose = LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7});
  RenderOptions options{.camera = kSmallCamera};
  options.noise = NoiseModel::Handa();
  Frame frames[2];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    const Renderer renderer(RoomWithBoxAndBall(), options, Coarse());
    frames[threads - 1] = renderer.Render(Still(pose), 0, 3);
  }
  SetThreadCount(0);
  EXPECT_EQ(frames[0].rgb, frames[1].rgb);
  EXPECT_EQ(frames[0].depth_m, frames[1].depth_m);
}

TEST(Renderer, RefusesOptionsThatMakeNoPicture) {
  const auto lit = std::make_shared<const LitScene>(RoomWithBoxAndBall(), Coarse());
  EXPECT_THROW(Renderer(lit, {.camera = {1, 1, 0, 0, 0, 0}}), Error);
  EXPECT_THROW(Renderer(lit, {.camera = kSmallCamera, .samples_per_pixel = 0}), Error);
  EXPECT_THROW(Renderer(lit, {.camera = kSmallCamera, .exposure_s = -1}), Error);
  EXPECT_THROW(Renderer(lit, {.camera = kSmallCamera, .exposure_s = std::nan("")}), Error);
  EXPECT_THROW(Renderer(lit, {.camera = kSmallCamera, .time_samples = 0}), Error);
}

}  // namespace
}  // namespace silt::sim
