// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT

// The presets accurate and fast on a walk: what they start from, and how they find back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "silt/tracker/keyframe_tracker.h"
#include "small_walk.h"

namespace silt::tracker {
namespace {

// The same answer whatever the frame.
struct FrameInitializer : Initializer {
  InitialEstimate Estimate(const InitializerInput&) override {
    ++*calls;
    return {answer, 50, 40, 1.5};
  }
  std::optional<SE3d> answer;
  int* calls = nullptr;
};

class OwnPreset : public testing::TestWithParam<std::string> {
 protected:
  static TrackerOptions Preset() {
    return GetParam() == "accurate" ? AccuratePreset() : FastPreset();
  }
};

// With the time between frames, an even motion foretells the next pose.
TEST_P(OwnPreset, FollowsAWalkWithoutAnInitializer) {
  int calls = 0;
  auto initializer = std::make_unique<FrameInitializer>();
  initializer->calls = &calls;
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
  for (int i = 0; i < 25; ++i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << i << ": " << tracked.message;
    EXPECT_LT(Distance(tracked.world_from_camera, TruePose(i)), 4e-3) << i;
  }
  EXPECT_EQ(calls, 0);
  EXPECT_GT(tracker.keyframes().size(), 2u);
}

// Without the time between frames nothing can be foretold: each alignment starts a step behind.
TEST_P(OwnPreset, StartsWhereAnEvenMotionLeads) {
  const auto start_cost = [&](double frame_time_s) {
    TrackerOptions options = Preset();
    options.alignment.max_iterations.pop_back();
    options.alignment.robust_scale = options.alignment.robust_gradient = 0;
    options.alignment.depth_residual = false;
    KeyframeTracker tracker = MakeTracker(nullptr, options);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
      const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i), frame_time_s * i));
      if (i >= 2) sum += tracked.alignment.levels.front().initial_cost.mean();
    }
    return sum;
  };
  EXPECT_LT(start_cost(0.1), 0.1 * start_cost(0));
}

// A jump to where the walk goes on: lost, until the features say where.
TEST_P(OwnPreset, AsksTheInitializerWhereLost) {
  int calls = 0;
  auto initializer = std::make_unique<FrameInitializer>();
  initializer->calls = &calls;
  initializer->answer = TruePose(19).Inverse() * TruePose(0);
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
  tracker.Track(RoomFrame(TruePose(0), 0));
  const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(19), 0.1));
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << tracked.message;
  EXPECT_LT(Distance(tracked.world_from_camera, TruePose(19)), 1e-2);
}

// What is made of a frame that is expected half a metre off, by a tracker that comes no nearer from
// there and calls nothing lost, with an initializer that gives this answer.
TrackedFrame DoubtfulFrame(TrackerOptions options, const std::optional<SE3d>& answer, int* calls) {
  auto initializer = std::make_unique<FrameInitializer>();
  initializer->calls = calls;
  initializer->answer = answer;
  options.alignment.max_iterations = {1};
  options.trust.max_unexplained_variance = options.trust.max_depth_disagreement = 1e6;
  options.trust.max_uncertainty_rad = 1e6;
  options.trust.min_inlier_ratio = 0;
  KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
  tracker.Track(RoomFrame(TruePose(0), 0));
  return tracker.Track(RoomFrame(TruePose(2), 0.1), TruePose(2) * SE3d::Exp({{}, {0.5, 0, 0}}));
}

TEST_P(OwnPreset, ADoubtfulFrameIsTriedAgainFromTheInitializersStart) {
  int calls = 0;
  const SE3d truth = TruePose(2).Inverse() * TruePose(0);
  const TrackedFrame doubtful = DoubtfulFrame(Preset(), {}, &calls);
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(doubtful.status, TrackingStatus::kDoubtful) << doubtful.message;
  const TrackedFrame tracked = DoubtfulFrame(Preset(), truth, &calls);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(tracked.status, TrackingStatus::kTracked) << tracked.message;
  EXPECT_LT(Distance(tracked.world_from_camera, TruePose(2)), 4e-3);
  EXPECT_EQ(tracked.initial.inliers, 40);
}

// What is made of a frame that is expected to look elsewhere, where what is left of the residuals
// is so much of what makes a pose doubtful.
TrackedFrame TurnedFrame(TrackerOptions options, double share, int* calls) {
  options.alignment.max_iterations = {1};
  options.trust = {};
  options.trust.max_unexplained_variance = options.trust.max_depth_disagreement = 1e6;
  options.trust.doubtful_depth_disagreement = options.trust.doubtful_uncertainty_rad = 1e6;
  options.trust.doubtful_inlier_ratio = options.trust.doubtful_overlap = 0;
  const auto track = [&](double doubtful) {
    auto initializer = std::make_unique<FrameInitializer>();
    initializer->calls = calls;
    options.trust.doubtful_unexplained_variance = doubtful;
    KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
    tracker.Track(RoomFrame(TruePose(0), 0));
    return tracker.Track(RoomFrame(TruePose(2), 0.1),
                         TruePose(2) * SE3d::Exp({{0, 0.1, 0}, {0, 0, 0}}));
  };
  return track(track(1e6).evidence.unexplained_variance / share);
}

// Without a call of the initializer, which takes its time.
TEST_P(OwnPreset, WhatComesNearDoubtIsTriedAgainFromTheTurnAlone) {
  int calls = 0;
  const auto error = [](const TrackedFrame& tracked) {
    EXPECT_EQ(tracked.status, TrackingStatus::kTracked) << tracked.message;
    return Angle(tracked.world_from_camera, TruePose(2));
  };
  const TrackedFrame as_it_is = TurnedFrame(Preset(), 0.25, &calls);
  const TrackedFrame again = TurnedFrame(Preset(), 0.35, &calls);
  EXPECT_EQ(calls, 0);
  EXPECT_FALSE(as_it_is.initial.current_from_keyframe);
  EXPECT_TRUE(again.initial.current_from_keyframe);
  EXPECT_LT(again.evidence.unexplained_variance, 0.2 * as_it_is.evidence.unexplained_variance);
  EXPECT_LT(error(again), 0.3 * error(as_it_is));
  TurnedFrame(Preset(), 1.1, &calls);
  EXPECT_EQ(calls, 1);
}

// A start that leads to more doubt, or nowhere, changes nothing; every start counts for a tracker
// that takes it from the initializer anyway.
TEST_P(OwnPreset, TheLesserDoubtIsKept) {
  int calls = 0;
  const TrackedFrame alone = DoubtfulFrame(Preset(), {}, &calls);
  for (const double off_m : {-0.9, 30.0}) {
    const SE3d wrong = (TruePose(2) * SE3d::Exp({{}, {off_m, 0, 0}})).Inverse() * TruePose(0);
    const TrackedFrame kept = DoubtfulFrame(Preset(), wrong, &calls);
    EXPECT_EQ(kept.status, TrackingStatus::kDoubtful);
    EXPECT_EQ(kept.message, alone.message);
    EXPECT_EQ(Distance(kept.world_from_camera, alone.world_from_camera), 0) << off_m;
    EXPECT_EQ(kept.evidence.unexplained_variance, alone.evidence.unexplained_variance);
  }
  EXPECT_EQ(calls, 3);
  TrackerOptions always = Preset();
  always.always_initialize = true;
  DoubtfulFrame(always, {}, &calls);
  EXPECT_EQ(calls, 4);
}

// No start makes images tell more than they do.
TEST_P(OwnPreset, AnUncertainFrameIsNotTriedAgain) {
  int calls = 0;
  auto initializer = std::make_unique<FrameInitializer>();
  initializer->calls = &calls;
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  options.trust.doubtful_uncertainty_rad = 1e-9;
  KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
  tracker.Track(RoomFrame(TruePose(0), 0));
  EXPECT_EQ(tracker.Track(RoomFrame(TruePose(1), 0.1)).status, TrackingStatus::kDoubtful);
  EXPECT_EQ(calls, 0);
}

// A walk past several keyframes, darkness, and back where it began: the nearest keyframe is not the
// one to ask, and nobody tells where to start.
TEST_P(OwnPreset, FindsItsWayBackToAnyKeyframe) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 30; ++i) tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
  ASSERT_GT(tracker.keyframes().size(), 3u);
  const TrackedFrame dark = tracker.Track(BlackFrame());
  EXPECT_EQ(dark.status, TrackingStatus::kLost);
  EXPECT_EQ(dark.covariance, Covariance6{});
  const TrackedFrame back = tracker.Track(RoomFrame(TruePose(0), 3.1));
  ASSERT_EQ(back.status, TrackingStatus::kTracked) << back.message;
  EXPECT_EQ(back.keyframe_id, 0);
  EXPECT_LT(Distance(back.world_from_camera, TruePose(0)), 4e-3);
  // The leap is no velocity.
  const TrackedFrame next = tracker.Track(RoomFrame(TruePose(1), 3.2));
  EXPECT_EQ(next.status, TrackingStatus::kTracked) << next.message;
}

// Knows nothing, and remembers what it was told of each keyframe.
struct AskedInitializer : Initializer {
  struct Asked {
    int keyframe_id;
    SE3d expected;
  };
  explicit AskedInitializer(std::vector<Asked>* all) : asked(all) {}
  InitialEstimate Estimate(const InitializerInput& input) override {
    asked->push_back({input.keyframe.id, input.expected});
    return {};
  }
  std::vector<Asked>* asked;
};

// Those that are expected in view are looked for there first, the nearest before all others; then
// all from their own places. Without a motion nothing but the nearest is expected anywhere.
TEST_P(OwnPreset, LooksForKeyframesWhereTheyAreExpected) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  std::vector<AskedInitializer::Asked> asked;
  KeyframeTracker tracker = MakeTracker(std::make_unique<AskedInitializer>(&asked), options);
  for (int i = 0; i < 30; ++i) tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
  ASSERT_TRUE(asked.empty());
  const SE3d expected = TruePose(28) * SE3d::Exp({{0, 0.2, 0}, {}});
  const auto count = [&](bool in_place) {
    return std::count_if(asked.begin(), asked.end(), [&](const auto& one) {
      const SE3d& keyframe = tracker.keyframes()[one.keyframe_id].world_from_camera;
      const SE3d wanted = in_place ? SE3d{} : expected.Inverse() * keyframe;
      return Distance(one.expected, wanted) + Angle(one.expected, wanted) < 1e-9;
    });
  };
  EXPECT_EQ(tracker.Track(BlackFrame(), expected).status, TrackingStatus::kLost);
  EXPECT_EQ(count(true), options.relocalization_candidates);
  EXPECT_GT(count(false), 1);
  EXPECT_EQ(count(true) + count(false), int(asked.size()));
  EXPECT_GT(Distance(asked.front().expected, {}), 0);
  asked.clear();
  EXPECT_EQ(tracker.Track(BlackFrame()).status, TrackingStatus::kLost);
  EXPECT_EQ(count(true), options.relocalization_candidates);
  EXPECT_EQ(asked.size(), 1u + options.relocalization_candidates);
}

// About itself, where the nearest keyframes in metres show other walls.
TEST_P(OwnPreset, TurnsOnTheSpotWithoutBeingLost) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 26; ++i) {
    const SE3d pose = kStart * SE3d::Exp({{0, 0.08 * i, 0}, {}});
    const TrackedFrame tracked = tracker.Track(RoomFrame(pose, 0.1 * i));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << i << ": " << tracked.message;
    EXPECT_LT(Angle(tracked.world_from_camera, pose), 4e-3) << i;
  }
}

TEST_P(OwnPreset, WithoutCandidatesItStaysLost) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  options.relocalization_candidates = 0;
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 30; ++i) tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
  const TrackedFrame back = tracker.Track(RoomFrame(TruePose(0), 3.1));
  EXPECT_EQ(back.status, TrackingStatus::kLost);
}

// What is known of some keyframes moves them, those that followed from them, and the camera.
TEST_P(OwnPreset, MovedKeyframesTakeTheCameraAlong) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 25; ++i) tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
  const std::size_t count = tracker.keyframes().size();
  ASSERT_GT(count, 2u);
  const SE3d move = SE3d::Exp({{0.2, -0.1, 0.3}, {1, 2, -3}});
  std::vector<SE3d> moved, expected;
  for (const Keyframe& keyframe : tracker.keyframes()) {
    expected.push_back(move * keyframe.world_from_camera);
    if (moved.size() + 1 < count) moved.push_back(expected.back());
  }
  tracker.MoveKeyframes(moved);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_LT(Distance(tracker.keyframes()[i].world_from_camera, expected[i]), 1e-9) << i;
  }
  const TrackedFrame next = tracker.Track(RoomFrame(TruePose(25), 2.5));
  EXPECT_EQ(next.status, TrackingStatus::kTracked) << next.message;
  EXPECT_LT(Distance(next.world_from_camera, move * TruePose(25)), 2e-2);
  EXPECT_LT(Angle(next.world_from_camera, move * TruePose(25)), 4e-3);
}

// Of a frame's pose, its own keyframe alone decides.
TEST_P(OwnPreset, TheCameraGoesWithTheKeyframeItIsTrackedFrom) {
  TrackerOptions options = Preset();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  TrackedFrame last;
  int i = 0;
  do {
    last = tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
    ++i;
  } while (tracker.keyframes().size() < 3 || last.new_keyframe);
  std::vector<SE3d> poses;
  for (const Keyframe& keyframe : tracker.keyframes()) poses.push_back(keyframe.world_from_camera);
  const SE3d aside{{}, {5, 0, 0}};
  poses[last.keyframe_id] = aside * poses[last.keyframe_id];
  tracker.MoveKeyframes(poses);
  const TrackedFrame dark = tracker.Track(BlackFrame());
  ASSERT_EQ(dark.status, TrackingStatus::kLost);
  EXPECT_LT(Distance(dark.world_from_camera, aside * last.world_from_camera), 1e-9);
}

Frame Dimmed(Frame frame, double gain) {
  for (Rgb8& pixel : frame.rgb) {
    const auto gray = std::uint8_t(std::lround(gain * double(pixel.r)));
    pixel = {gray, gray, gray};
  }
  return frame;
}

// Along a walk without another reason for keyframes, into the dark.
int LostInTheDark(TrackerOptions options, int* keyframes) {
  options.alignment.max_iterations.pop_back();
  options.keyframes.max_distance_m = 3;
  options.keyframes.min_overlap = 0;
  options.trust.doubtful_uncertainty_rad = 0.03;
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  int untracked = 0;
  for (int i = 0; i < 20; ++i) {
    const Frame frame = Dimmed(RoomFrame(TruePose(i), 0.1 * i), std::pow(0.985, i));
    if (tracker.Track(frame).status != TrackingStatus::kTracked) ++untracked;
  }
  *keyframes = int(tracker.keyframes().size());
  return untracked;
}

// Before frames become doubtful, of which no keyframe is made, the light that they are in is known.
TEST_P(OwnPreset, AKeyframeThatGoesStaleIsReplacedInTime) {
  int keyframes = 0;
  EXPECT_EQ(LostInTheDark(Preset(), &keyframes), 0);
  EXPECT_GT(keyframes, 1);
  EXPECT_LT(keyframes, 10);
  TrackerOptions without = Preset();
  without.keyframes.stale_share = 0;
  EXPECT_GT(LostInTheDark(without, &keyframes), 5);
  EXPECT_EQ(keyframes, 1);
}

// Root mean square of the keyframes' errors in position, of a tracker of coarse images.
double KeyframeError(int polish_iterations) {
  TrackerOptions options = FastPreset();
  options.alignment.max_iterations = {0, 0, 20};
  options.keyframes.polish_iterations = polish_iterations;
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  double squares = 0;
  for (int i = 0; i < 25; ++i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
    if (tracked.new_keyframe)
      squares += std::pow(Distance(tracked.world_from_camera, TruePose(i)), 2);
  }
  return std::sqrt(squares / double(tracker.keyframes().size()));
}

TEST(KeyframeTracker, WhatBecomesAKeyframeIsPolished) {
  EXPECT_LT(KeyframeError(10), 0.3 * KeyframeError(0));
}

INSTANTIATE_TEST_SUITE_P(KeyframeTracker, OwnPreset, testing::Values("accurate", "fast"));

}  // namespace
}  // namespace silt::tracker
