// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe_tracker.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "analytic_room.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/tracker/cpu_backend.h"

namespace silt::tracker {
namespace {

using testing::HasSubstr;

const SE3d kStart{Quaterniond::Exp({0.1, 0.3, 0}), {0.1, 0, -0.4}};

// A walk of small steps, 3 cm and 1° a frame.
SE3d TruePose(int frame) {
  const double s = frame;
  return kStart * SE3d::Exp({{0.004 * s, 0.017 * s, 0}, {0.03 * s, 0.004 * s, 0.005 * s}});
}

TrackerOptions SmallImages() {
  TrackerOptions options;
  options.alignment.max_iterations = {10, 10, 20};
  return options;
}

KeyframeTracker MakeTracker(std::unique_ptr<Initializer> initializer = nullptr,
                            const TrackerOptions& options = SmallImages()) {
  return KeyframeTracker(kSmallCamera, options, MakeCpuBackend(), std::move(initializer), kStart);
}

// Says what the test tells it to, and remembers what it was asked.
struct ScriptedInitializer : Initializer {
  InitialEstimate Estimate(const InitializerInput& input) override {
    ++*calls;
    EXPECT_EQ(input.frame_index, *calls);
    EXPECT_EQ(input.intensity.width(), kSmallCamera.width);
    return {answer, 50, 40, 1.5};
  }
  std::optional<SE3d> answer;
  int own_calls = 0;
  int* calls = &own_calls;
};

// The same answer whatever the frame.
struct FrameInitializer : Initializer {
  InitialEstimate Estimate(const InitializerInput&) override {
    ++*calls;
    return {answer, 50, 40, 1.5};
  }
  std::optional<SE3d> answer;
  int* calls = nullptr;
};

TEST(KeyframeTracker, TheFirstFrameIsTheFirstKeyframe) {
  KeyframeTracker tracker = MakeTracker();
  const TrackedFrame first = tracker.Track(RoomFrame(kStart, 1.5));
  EXPECT_EQ(first.status, TrackingStatus::kTracked);
  EXPECT_TRUE(first.new_keyframe);
  EXPECT_EQ(first.keyframe_id, 0);
  EXPECT_EQ(first.time_s, 1.5);
  EXPECT_EQ(Distance(first.world_from_camera, kStart), 0);
  ASSERT_EQ(tracker.keyframes().size(), 1u);
  EXPECT_EQ(tracker.keyframes()[0].frame.time_s, 1.5);
}

TEST(KeyframeTracker, AFrameThatIsGivenAwayIsNotCopied) {
  KeyframeTracker tracker(kSmallCamera, PaperPreset(), MakeCpuBackend(), nullptr);
  Frame frame = RoomFrame(kStart), next = frame;
  const float* const depth_m = frame.depth_m.data();
  tracker.Track(std::move(frame));
  EXPECT_EQ(tracker.keyframes()[0].frame.depth_m.data(), depth_m);
  tracker.Track(std::move(next));
  EXPECT_FALSE(next.depth_m.empty());  // NOLINT(bugprone-use-after-move): it is no keyframe
}

TEST(KeyframeTracker, FollowsAWalkFromKeyframeToKeyframe) {
  KeyframeTracker tracker = MakeTracker();
  int keyframes = 0;
  for (int i = 0; i < 20; ++i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i)));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << i << ": " << tracked.message;
    EXPECT_LT(Distance(tracked.world_from_camera, TruePose(i)), 4e-3) << i;
    EXPECT_LT(Angle(tracked.world_from_camera, TruePose(i)), 2e-3) << i;
    keyframes += tracked.new_keyframe ? 1 : 0;
    EXPECT_GT(tracked.times.total_ms, 0);
  }
  // 0.6 m at one keyframe per five steps of 3 cm.
  EXPECT_EQ(keyframes, 4);
  EXPECT_EQ(int(tracker.keyframes().size()), keyframes);
}

TEST(KeyframeTracker, ComesBackToOldKeyframesWithoutMakingNewOnes) {
  KeyframeTracker tracker = MakeTracker();
  for (int i = 0; i < 12; ++i) tracker.Track(RoomFrame(TruePose(i)));
  const std::size_t keyframes = tracker.keyframes().size();
  int last_id = -1;
  for (int i = 11; i >= 0; --i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i)));
    EXPECT_FALSE(tracked.new_keyframe);
    last_id = tracked.keyframe_id;
  }
  EXPECT_EQ(last_id, 0);
  EXPECT_EQ(tracker.keyframes().size(), keyframes);
}

TEST(KeyframeTracker, StartsFromTheInitializer) {
  auto initializer = std::make_unique<ScriptedInitializer>();
  const SE3d far = kStart * SE3d::Exp({{0, 0.25, 0}, {0.4, 0, 0}});
  initializer->answer = far.Inverse() * kStart;
  KeyframeTracker tracker = MakeTracker(std::move(initializer));
  tracker.Track(RoomFrame(kStart));
  const TrackedFrame tracked = tracker.Track(RoomFrame(far));
  EXPECT_EQ(tracked.initial.inliers, 40);
  EXPECT_LT(Distance(tracked.world_from_camera, far), 4e-3);
  // From the previous pose alone it is too far.
  KeyframeTracker without = MakeTracker();
  without.Track(RoomFrame(kStart));
  EXPECT_GT(Distance(without.Track(RoomFrame(far)).world_from_camera, far), 0.05);
}

TEST(KeyframeTracker, WithoutAnEstimateStartsFromThePreviousPose) {
  int calls = 0;
  auto initializer = std::make_unique<ScriptedInitializer>();
  initializer->calls = &calls;
  KeyframeTracker tracker = MakeTracker(std::move(initializer));
  for (int i = 0; i < 4; ++i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i)));
    EXPECT_EQ(tracked.status, TrackingStatus::kTracked);
    EXPECT_LT(Distance(tracked.world_from_camera, TruePose(i)), 4e-3) << i;
  }
  EXPECT_EQ(calls, 3);  // the first frame needs none
}

struct BadView {
  const char* name;
  Frame (*make)();
};

void PrintTo(const BadView& bad, std::ostream* out) { *out << bad.name; }

Frame BlackFrame() { return {0, Image<Rgb8>(160, 120), Image<float>(160, 120, 1.0f)}; }
Frame GrayFrame() {
  return {0, Image<Rgb8>(160, 120, {128, 128, 128}), Image<float>(160, 120, 1.0f)};
}
Frame OtherWall() { return RoomFrame(kStart * SE3d{Quaterniond::Exp({0, 2.6, 0}), {}}); }
Frame Stripes() {
  Frame frame = GrayFrame();
  for (int i = 0; i < 160 * 120; ++i) {
    const auto gray = std::uint8_t(i / 160 % 16 < 8 ? 0 : 255);
    frame.rgb.data()[i] = {gray, gray, gray};
  }
  return frame;
}

class LostOn : public testing::TestWithParam<BadView> {};

TEST_P(LostOn, KeepsTheLastPoseSaysSoAndRecovers) {
  KeyframeTracker tracker = MakeTracker();
  tracker.Track(RoomFrame(TruePose(0)));
  const SE3d last = tracker.Track(RoomFrame(TruePose(1))).world_from_camera;
  const TrackedFrame lost = tracker.Track(GetParam().make());
  EXPECT_EQ(lost.status, TrackingStatus::kLost);
  EXPECT_THAT(lost.message, HasSubstr("lost: "));
  EXPECT_FALSE(lost.new_keyframe);
  EXPECT_EQ(Distance(lost.world_from_camera, last), 0);
  const TrackedFrame again = tracker.Track(RoomFrame(TruePose(2)));
  EXPECT_EQ(again.status, TrackingStatus::kTracked) << again.message;
  EXPECT_LT(Distance(again.world_from_camera, TruePose(2)), 4e-3);
}

INSTANTIATE_TEST_SUITE_P(KeyframeTracker, LostOn,
                         testing::Values(BadView{"black", BlackFrame}, BadView{"gray", GrayFrame},
                                         BadView{"another_wall", OtherWall},
                                         BadView{"stripes", Stripes}),
                         [](const auto& p) { return std::string(p.param.name); });

TEST(KeyframeTracker, AFrameWithoutDepthIsTrackedButNoKeyframe) {
  KeyframeTracker tracker = MakeTracker();
  for (int i = 0; i < 5; ++i) tracker.Track(RoomFrame(TruePose(i)));
  const std::size_t keyframes = tracker.keyframes().size();
  Frame blind = RoomFrame(TruePose(5));
  blind.depth_m = {};
  const TrackedFrame tracked = tracker.Track(blind);
  EXPECT_EQ(tracked.status, TrackingStatus::kTracked);
  EXPECT_FALSE(tracked.new_keyframe);
  EXPECT_EQ(tracked.message, "not a keyframe: 0 % of its depth is measured");
  EXPECT_EQ(tracker.keyframes().size(), keyframes);
  // The next one with a depth takes its place.
  EXPECT_TRUE(tracker.Track(RoomFrame(TruePose(6))).new_keyframe);
}

TEST(KeyframeTracker, WaitsForAFirstDepth) {
  KeyframeTracker tracker = MakeTracker();
  Frame blind = RoomFrame(kStart);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::fill(blind.depth_m.begin(), blind.depth_m.end(), nan);
  const TrackedFrame waiting = tracker.Track(blind);
  EXPECT_EQ(waiting.status, TrackingStatus::kLost);
  EXPECT_EQ(waiting.keyframe_id, -1);
  EXPECT_THAT(waiting.message, HasSubstr("not a keyframe"));
  EXPECT_TRUE(tracker.Track(RoomFrame(kStart)).new_keyframe);
}

TEST(KeyframeTracker, ImagesOfAnotherSizeAreAnError) {
  KeyframeTracker tracker = MakeTracker();
  Frame frame = RoomFrame(kStart);
  frame.depth_m = Image<float>(80, 60, 1.0f);
  try {
    tracker.Track(frame);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("frame 0: its depth has 80x60 pixels and the camera 160"));
  }
  frame.rgb = Image<Rgb8>(10, 10);
  EXPECT_THROW(tracker.Track(frame), Error);
}

TEST(KeyframeTracker, InvalidOptionsAreAnError) {
  TrackerOptions options;
  options.keyframes.max_distance_m = -1;
  EXPECT_THROW(MakeTracker(nullptr, options), Error);
}

class OwnPreset : public testing::TestWithParam<TrackerOptions> {};

// With the time between frames, an even motion foretells the next pose.
TEST_P(OwnPreset, FollowsAWalkWithoutAnInitializer) {
  int calls = 0;
  auto initializer = std::make_unique<ScriptedInitializer>();
  initializer->calls = &calls;
  TrackerOptions options = GetParam();
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
    TrackerOptions options = GetParam();
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

TEST(KeyframeTracker, StartsWhereTheOptionsSay) {
  const auto start = [&](Start kind) {
    TrackerOptions options = SmallImages();
    options.start = kind;
    KeyframeTracker walking = MakeTracker(nullptr, options);
    for (int i = 0; i < 3; ++i) walking.Track(RoomFrame(TruePose(i), 0.1 * i));
    return walking.Track(RoomFrame(TruePose(3), 0.3)).alignment.levels.front().initial_cost.mean();
  };
  EXPECT_LT(start(Start::kConstantVelocity), 0.2 * start(Start::kPrevious));
  EXPECT_LT(start(Start::kPrevious), 0.5 * start(Start::kKeyframe));
}

// A jump to where the walk goes on: lost, until the features say where.
TEST_P(OwnPreset, AsksTheInitializerWhereLost) {
  int calls = 0;
  auto initializer = std::make_unique<FrameInitializer>();
  initializer->calls = &calls;
  initializer->answer = TruePose(19).Inverse() * TruePose(0);
  TrackerOptions options = GetParam();
  options.alignment.max_iterations.pop_back();
  KeyframeTracker tracker = MakeTracker(std::move(initializer), options);
  tracker.Track(RoomFrame(TruePose(0), 0));
  const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(19), 0.1));
  EXPECT_EQ(calls, 1);
  ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << tracked.message;
  EXPECT_LT(Distance(tracked.world_from_camera, TruePose(19)), 1e-2);
}

// A walk past several keyframes, darkness, and back where it began: the nearest keyframe is not the
// one to ask, and nobody tells where to start.
TEST_P(OwnPreset, FindsItsWayBackToAnyKeyframe) {
  TrackerOptions options = GetParam();
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
  TrackerOptions options = GetParam();
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
  TrackerOptions options = GetParam();
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
  TrackerOptions options = GetParam();
  options.alignment.max_iterations.pop_back();
  options.relocalization_candidates = 0;
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 30; ++i) tracker.Track(RoomFrame(TruePose(i), 0.1 * i));
  const TrackedFrame back = tracker.Track(RoomFrame(TruePose(0), 3.1));
  EXPECT_EQ(back.status, TrackingStatus::kLost);
}

TEST(KeyframeTracker, ADoubtfulFrameIsNoKeyframeWhereOnlyTrustedOnesAre) {
  TrackerOptions options = SmallImages();
  options.trust.doubtful_overlap = 1;
  const auto keyframes = [&](bool trusted_only) {
    options.keyframes.trusted_only = trusted_only;
    KeyframeTracker tracker = MakeTracker(nullptr, options);
    for (int i = 0; i < 9; ++i) {
      const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i)));
      EXPECT_EQ(tracked.status, i > 0 ? TrackingStatus::kDoubtful : TrackingStatus::kTracked) << i;
      EXPECT_LT(Distance(tracked.world_from_camera, TruePose(i)), 4e-3) << i;
    }
    return tracker.keyframes().size();
  };
  EXPECT_EQ(keyframes(true), 1u);
  EXPECT_EQ(keyframes(false), 2u);
}

// The keyframe's own error adds to that of the alignment with it.
TEST(KeyframeTracker, CovariancesGrowFromKeyframeToKeyframe) {
  KeyframeTracker tracker = MakeTracker();
  const TrackedFrame first = tracker.Track(RoomFrame(TruePose(0)));
  EXPECT_EQ(first.covariance, Covariance6{});
  std::vector<double> deviations;
  for (int i = 1; i < 16; ++i) {
    const TrackedFrame tracked = tracker.Track(RoomFrame(TruePose(i)));
    EXPECT_GT(LargestDeviation(tracked.covariance, 1), 0);
    if (tracked.new_keyframe) deviations.push_back(LargestDeviation(tracked.covariance, 1));
  }
  ASSERT_GE(deviations.size(), 3u);
  EXPECT_GT(deviations[1], deviations[0]);
  EXPECT_GT(deviations[2], deviations[1]);
}

INSTANTIATE_TEST_SUITE_P(KeyframeTracker, OwnPreset,
                         testing::Values(AccuratePreset(), FastPreset()));

TEST(KeyframeTracker, TheBitsDoNotDependOnTheNumberOfThreads) {
  const auto run = [](int threads) {
    SetThreadCount(threads);
    KeyframeTracker tracker = MakeTracker();
    for (int i = 0; i < 7; ++i) tracker.Track(RoomFrame(TruePose(i)));
    return tracker.Track(RoomFrame(TruePose(7))).world_from_camera;
  };
  const SE3d one = run(1), two = run(2), three = run(3);
  SetThreadCount(0);
  EXPECT_EQ(Distance(one, two) + Distance(one, three), 0);
  EXPECT_EQ(one.rotation.x, two.rotation.x);
  EXPECT_EQ(one.rotation.x, three.rotation.x);
}

}  // namespace
}  // namespace silt::tracker
