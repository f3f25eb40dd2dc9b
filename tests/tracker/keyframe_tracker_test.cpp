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
#include "small_walk.h"

namespace silt::tracker {
namespace {

using testing::HasSubstr;

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
