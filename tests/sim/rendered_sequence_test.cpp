// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/rendered_sequence.h"

#include <gtest/gtest.h>

#include "key_poses.h"
#include "scene_builder.h"
#include "silt/core/error.h"
#include "silt/sim/path_file.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{60, 60, 39.5, 29.5, 80, 60};

std::shared_ptr<const Renderer> RoomRenderer() {
  static const auto renderer = [] {
    LightingOptions coarse;
    coarse.direct_spacing_m = coarse.indirect_spacing_m = 0.5f;
    RenderOptions options{.camera = kCamera, .shutter = {.exposure_s = 1.0 / 60}};
    options.sensor.noise = HandaNoise{};
    return std::make_shared<const Renderer>(RoomWithBoxAndBall(), options, coarse);
  }();
  return renderer;
}

// One second of a camera that moves to the right.
std::shared_ptr<const CameraPath> Path() {
  Trajectory keys;
  for (int i = 0; i <= 4; ++i) {
    keys.push_back({0.25 * i, LookAt({-0.5 + 0.2 * i, -1.8, 1.4}, {0, 1, 0.7})});
  }
  return std::make_shared<const CameraPath>(PoseSpline::Through(keys));
}

TEST(RenderedSequence, DeliversEveryFrameOnce) {
  RenderedSequence sequence(RoomRenderer(), Path(), {.fps = 20, .duration_s = 0.2});
  EXPECT_EQ(sequence.size(), 4);
  EXPECT_EQ(sequence.camera().width, 80);
  for (int i = 0; i < sequence.size(); ++i) {
    const std::optional<Frame> frame = sequence.Next();
    ASSERT_TRUE(frame);
    EXPECT_DOUBLE_EQ(frame->time_s, i / 20.0);
    EXPECT_EQ(frame->rgb, sequence.At(i).rgb);
    EXPECT_EQ(frame->depth_m, sequence.At(i).depth_m);
  }
  EXPECT_FALSE(sequence.Next());
}

TEST(RenderedSequence, KnowsTheTruePoses) {
  const auto path = Path();
  const RenderedSequence sequence(RoomRenderer(), path, {.fps = 10});
  EXPECT_EQ(sequence.size(), 10);
  for (int i = 0; i < sequence.size(); ++i) {
    const StampedPose& pose = sequence.GroundTruth()[std::size_t(i)];
    EXPECT_DOUBLE_EQ(pose.time_s, i / 10.0);
    EXPECT_LT(PoseDistance(pose.world_from_camera, path->WorldFromCamera(i / 10.0)), 1e-12);
  }
  const Renderer& renderer = *RoomRenderer();
  EXPECT_EQ(sequence.At(7).depth_m, renderer.RenderDepth(path->WorldFromCamera(0.7)));
}

TEST(RenderedSequence, AStretchIsAPartOfTheWholeNoiseIncluded) {
  const RenderedSequence whole(RoomRenderer(), Path(), {.fps = 30});
  const RenderedSequence part(RoomRenderer(), Path(), {.fps = 30, .start_s = 0.5});
  EXPECT_EQ(part.size(), 15);
  EXPECT_EQ(part.At(3).time_s, whole.At(18).time_s);
  EXPECT_EQ(part.At(3).rgb, whole.At(18).rgb);
  EXPECT_FALSE(part.At(3).rgb == part.At(4).rgb);
}

TEST(RenderedSequence, RefusesTimesThatThePathDoesNotHave) {
  const auto make = [](const SequenceTiming& timing) {
    RenderedSequence(RoomRenderer(), Path(), timing);
  };
  EXPECT_THROW(make({.fps = 0}), Error);
  EXPECT_THROW(make({.start_s = -1}), Error);
  EXPECT_THROW(make({.start_s = 1.5}), Error);
  EXPECT_THROW(make({.duration_s = 1.5}), Error);
  EXPECT_THROW(make({.duration_s = -1}), Error);
}

}  // namespace
}  // namespace silt::sim
