// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/background_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "small_walk.h"

namespace silt::tracker {
namespace {

constexpr int kFrames = 40;

// There and back again, a little aside.
SE3d WalkPose(int i) {
  const int back = std::max(0, i - kFrames / 2);
  return TruePose(back > 0 ? kFrames - i : i) * SE3d::Exp({{}, {0, 0.02 * std::min(5, back), 0}});
}

// A tracker that looks at coarse images alone, and so drifts.
TrackerOptions Coarse() {
  TrackerOptions options = AccuratePreset();
  options.alignment.max_iterations = {0, 0, 20};
  options.keyframes.joint = 1;
  options.keyframes.max_distance_m = 0.08;
  return options;
}

KeyframeGraphOptions Fine() {
  KeyframeGraphOptions options{AccuratePreset().alignment, AccuratePreset().trust};
  options.alignment.max_iterations = {10, 10, 20};
  options.recent = 3;
  return options;
}

// A backend that takes its time.
class SlowBackend : public Backend {
 public:
  std::string name() const override { return "slow"; }
  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>& intensity,
                                                  const Image<float>& depth_m,
                                                  const PinholeCamera& camera,
                                                  const PyramidOptions& options) const override {
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
    return cpu_->MakeReference(intensity, depth_m, camera, options);
  }
  std::unique_ptr<CurrentPyramid> MakeCurrent(const Image<float>& intensity,
                                              const Image<float>& depth_m,
                                              const PyramidOptions& options) const override {
    return cpu_->MakeCurrent(intensity, depth_m, options);
  }
  std::unique_ptr<ReferencePyramid> WithoutHidden(
      const ImagePair& pair, int level, const SE3d& current_from_reference) const override {
    return cpu_->WithoutHidden(pair, level, current_from_reference);
  }
  PhotometricCost Cost(const ImagePair& pair, int level,
                       const SE3d& current_from_reference) const override {
    return cpu_->Cost(pair, level, current_from_reference);
  }
  NormalEquations Linearize(const ImagePair& pair, int level, const SE3d& current_from_reference,
                            const ResidualNorm& norm) const override {
    return cpu_->Linearize(pair, level, current_from_reference, norm);
  }

 private:
  std::shared_ptr<const Backend> cpu_ = MakeCpuBackend();
};

const std::vector<Frame>& Frames() {
  static const std::vector<Frame> frames = [] {
    std::vector<Frame> all;
    for (int i = 0; i < kFrames; ++i) all.push_back(RoomFrame(WalkPose(i), 0.1 * i));
    return all;
  }();
  return frames;
}

struct Walk {
  std::vector<SE3d> told;  // frame by frame
  std::vector<Keyframe> keyframes;
  int loops = 0;
};

// `after_frame` is handed the tracker and what it said of each frame.
template <typename AfterFrame>
Walk FollowWalk(const AfterFrame& after_frame) {
  KeyframeTracker tracker = MakeTracker(nullptr, Coarse());
  Walk walk;
  for (const Frame& frame : Frames()) {
    TrackedFrame tracked = tracker.Track(frame);
    after_frame(&tracker, &tracked);
    walk.told.push_back(tracked.world_from_camera);
  }
  walk.keyframes = tracker.keyframes();
  return walk;
}

Walk InBackground(std::shared_ptr<const Backend> backend) {
  BackgroundGraph graph(kSmallCamera, Fine(), std::move(backend));
  Walk walk = FollowWalk(
      [&](KeyframeTracker* tracker, TrackedFrame* tracked) { graph.Take(tracker, tracked); });
  walk.loops = graph.Finished().loops();
  return walk;
}

double RootMeanSquare(const Walk& walk) {
  double squares = 0;
  for (int i = 0; i < kFrames; ++i) {
    const double error = Distance(walk.told[i], WalkPose(i));
    squares += error * error / kFrames;
  }
  return std::sqrt(squares);
}

void ExpectSameBits(const SE3d& a, const SE3d& b) {
  EXPECT_EQ(Norm(a.translation - b.translation), 0);
  EXPECT_EQ(a.rotation.x, b.rotation.x);
  EXPECT_EQ(a.rotation.y, b.rotation.y);
  EXPECT_EQ(a.rotation.z, b.rotation.z);
}

void ExpectSameBits(const Walk& a, const Walk& b) {
  for (int i = 0; i < kFrames; ++i) ExpectSameBits(a.told[i], b.told[i]);
  ASSERT_EQ(a.keyframes.size(), b.keyframes.size());
  for (std::size_t i = 0; i < a.keyframes.size(); ++i) {
    ExpectSameBits(a.keyframes[i].world_from_camera, b.keyframes[i].world_from_camera);
  }
}

TEST(BackgroundGraph, WhatTheTrackerTellsGetsBetterOnTheWay) {
  const double alone = RootMeanSquare(FollowWalk([](KeyframeTracker*, TrackedFrame*) {}));
  const Walk walk = InBackground(MakeCpuBackend());
  EXPECT_GT(walk.loops, 0);
  EXPECT_GT(alone, 1e-3);
  EXPECT_LT(RootMeanSquare(walk), 0.6 * alone);
}

// The same in turns, without any thread: what is known at one keyframe moves all at the next.
TEST(BackgroundGraph, TakesOverAtTheNextKeyframe) {
  KeyframeGraph graph(kSmallCamera, Fine(), MakeCpuBackend());
  const Walk in_turns = FollowWalk([&](KeyframeTracker* tracker, TrackedFrame* tracked) {
    if (!tracked->new_keyframe) return;
    tracker->MoveKeyframes(graph.keyframe_poses());
    tracked->world_from_camera = tracker->keyframes().back().world_from_camera;
    graph.Take(tracker->keyframes(), *tracked);
  });
  ExpectSameBits(InBackground(MakeCpuBackend()), in_turns);
}

TEST(BackgroundGraph, TheBitsDependOnNeitherTimeNorThreads) {
  SetThreadCount(1);
  const Walk one = InBackground(std::make_shared<SlowBackend>());
  SetThreadCount(3);
  const Walk three = InBackground(MakeCpuBackend());
  SetThreadCount(0);
  ExpectSameBits(one, three);
}

TEST(BackgroundGraph, TakeWaitsForAThreadThatIsLate) {
  BackgroundGraph graph(kSmallCamera, Fine(), std::make_shared<SlowBackend>());
  const Walk walk = FollowWalk(
      [&](KeyframeTracker* tracker, TrackedFrame* tracked) { graph.Take(tracker, tracked); });
  EXPECT_GT(graph.waited_ms(), 0);
  EXPECT_EQ(graph.Finished().keyframe_poses().size(), walk.keyframes.size());
}

struct FailingBackend : SlowBackend {
  std::unique_ptr<ReferencePyramid> MakeReference(const Image<float>&, const Image<float>&,
                                                  const PinholeCamera&,
                                                  const PyramidOptions&) const override {
    throw Error("out of memory");
  }
};

TEST(BackgroundGraph, AFailureOnTheThreadReachesTheCaller) {
  EXPECT_THROW(InBackground(std::make_shared<FailingBackend>()), Error);
}

}  // namespace
}  // namespace silt::tracker
