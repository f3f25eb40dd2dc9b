// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/keyframe_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analytic_room.h"
#include "silt/core/parallel.h"
#include "silt/tracker/cpu_backend.h"

namespace silt::tracker {
namespace {

constexpr int kKeyframes = 16;

// Along the room and back, so that the last keyframe stands beside the first.
SE3d TruePose(int i) {
  const double there = i < kKeyframes / 2 ? i : kKeyframes - 1 - i, beside = i >= kKeyframes / 2;
  return SE3d::Exp({{0, 0.3 + 0.02 * there, 0}, {0.08 * there, 0.03 * beside, -0.4}});
}

KeyframeGraphOptions SmallImages() {
  KeyframeGraphOptions options{AccuratePreset().alignment, AccuratePreset().trust};
  options.alignment.max_iterations = {10, 10, 20};
  options.recent = 4;
  return options;
}

// A tracker that errs by the same 1.5 mm and 1 mrad from each keyframe to the next.
struct DriftingTracker {
  std::vector<Keyframe> keyframes;

  TrackedFrame Next() {
    const int id = int(keyframes.size());
    Keyframe keyframe{id, RoomFrame(TruePose(id)), {}, TruePose(id)};
    TrackedFrame tracked;
    tracked.status = TrackingStatus::kTracked;
    tracked.keyframe_id = std::max(0, id - 1);
    tracked.new_keyframe = true;
    if (id > 0) {
      const SE3d drift = SE3d::Exp({{0, 1e-3, 0}, {1.5e-3, 0, 0}});
      tracked.alignment.current_from_reference = drift * TruePose(id).Inverse() * TruePose(id - 1);
      for (int i = 0; i < 6; ++i) tracked.alignment.covariance[7 * i] = 1e-6;
      keyframe.world_from_camera =
          keyframes.back().world_from_camera * tracked.alignment.current_from_reference.Inverse();
    }
    tracked.world_from_camera = keyframe.world_from_camera;
    keyframes.push_back(std::move(keyframe));
    return tracked;
  }
};

struct WholeRun {
  DriftingTracker tracker;
  KeyframeGraph graph;
};

WholeRun RunAll(const KeyframeGraphOptions& options = SmallImages()) {
  WholeRun run{{}, KeyframeGraph(kSmallCamera, options, MakeCpuBackend())};
  for (int i = 0; i < kKeyframes; ++i) {
    const TrackedFrame tracked = run.tracker.Next();
    run.graph.Take(run.tracker.keyframes, tracked);
  }
  return run;
}

TEST(KeyframeGraph, UndoesTheDriftWhereThePathComesBack) {
  const WholeRun run = RunAll();
  EXPECT_GT(run.graph.loops(), 4);
  ASSERT_EQ(run.graph.keyframe_poses().size(), std::size_t(kKeyframes));
  double drifted = 0, corrected = 0;
  for (int i = 0; i < kKeyframes; ++i) {
    drifted = std::max(drifted, Distance(run.tracker.keyframes[i].world_from_camera, TruePose(i)));
    corrected = std::max(corrected, Distance(run.graph.keyframe_poses()[i], TruePose(i)));
  }
  EXPECT_GT(drifted, 0.015);
  EXPECT_LT(corrected, drifted / 4);
}

TEST(KeyframeGraph, WithoutPartnersAllStaysAsItWasTracked) {
  KeyframeGraphOptions options = SmallImages();
  options.neighbours = options.loops = 0;
  const WholeRun run = RunAll(options);
  EXPECT_EQ(run.graph.edges().size(), std::size_t(kKeyframes - 1));
  EXPECT_EQ(run.graph.loops(), 0);
  for (int i = 0; i < kKeyframes; ++i) {
    const SE3d& tracked = run.tracker.keyframes[i].world_from_camera;
    EXPECT_LT(Distance(run.graph.keyframe_poses()[i], tracked), 1e-9);
  }
}

TEST(KeyframeGraph, TakesAsManyPartnersAsItMay) {
  KeyframeGraphOptions options = SmallImages();
  options.neighbours = 1;
  options.loops = 0;
  EXPECT_EQ(RunAll(options).graph.loops(), 0);
  EXPECT_LE(RunAll(options).graph.edges().size(), std::size_t(2 * kKeyframes));
  options.min_overlap = 1.1;
  EXPECT_EQ(RunAll(options).graph.edges().size(), std::size_t(kKeyframes - 1));
}

TEST(KeyframeGraph, WhatIsDoubtfulMakesNoEdge) {
  KeyframeGraphOptions options = SmallImages();
  options.trust.doubtful_overlap = 1;  // which no two keyframes have
  EXPECT_EQ(RunAll(options).graph.edges().size(), std::size_t(kKeyframes - 1));
}

// The last keyframe shows another wall than its pose says.
TEST(KeyframeGraph, AWrongViewConnectsNothing) {
  DriftingTracker tracker;
  KeyframeGraph graph(kSmallCamera, SmallImages(), MakeCpuBackend());
  for (int i = 0; i < 3; ++i) {
    const TrackedFrame tracked = tracker.Next();
    if (i == 2) tracker.keyframes[i].frame = RoomFrame(SE3d::Exp({{0, 2.9, 0}, {}}));
    graph.Take(tracker.keyframes, tracked);
  }
  EXPECT_EQ(graph.edges().size(), 2u);
}

TEST(KeyframeGraph, FramesAreCarriedByTheirKeyframes) {
  WholeRun run = RunAll();
  const SE3d keyframe_from_frame = SE3d::Exp({{0.01, 0, 0}, {0, 0.02, 0}});
  TrackedFrame frame;
  frame.status = TrackingStatus::kTracked;
  frame.keyframe_id = 9;
  frame.world_from_camera = run.tracker.keyframes[9].world_from_camera * keyframe_from_frame;
  run.graph.Take(run.tracker.keyframes, frame);
  frame.status = TrackingStatus::kLost;
  frame.keyframe_id = 2;
  run.graph.Take(run.tracker.keyframes, frame);
  const std::vector<SE3d> poses = run.graph.FramePoses();
  ASSERT_EQ(poses.size(), std::size_t(kKeyframes + 2));
  const SE3d expected = run.graph.keyframe_poses()[9] * keyframe_from_frame;
  EXPECT_LT(Distance(poses[kKeyframes], expected), 1e-12);
  EXPECT_EQ(Distance(poses[kKeyframes + 1], poses[kKeyframes]), 0);
  EXPECT_LT(Distance(poses[3], run.graph.keyframe_poses()[3]), 1e-12);
}

TEST(KeyframeGraph, TheBitsDoNotDependOnTheNumberOfThreads) {
  const auto poses = [](int threads) {
    SetThreadCount(threads);
    return RunAll().graph.keyframe_poses();
  };
  const std::vector<SE3d> one = poses(1), three = poses(3);
  SetThreadCount(0);
  for (int i = 0; i < kKeyframes; ++i) {
    EXPECT_EQ(one[i].translation.x, three[i].translation.x);
    EXPECT_EQ(one[i].rotation.y, three[i].rotation.y);
  }
}

}  // namespace
}  // namespace silt::tracker
