// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "silt/core/random.h"
#include "silt/experiments/pose_difference.h"
#include "silt/experiments/tracker_setup.h"
#include "studio_world.h"

// What a tracker makes of frames that it should not believe, in the rendered studio.
namespace silt::experiments {
namespace {

using tracker::TrackedFrame;
using tracker::TrackingStatus;

Frame StudioFrame(double time_s) { return RenderAt(StudioWorld(), SmallPictures(), time_s); }
SE3d TruePose(double time_s) { return StudioWorld().path.WorldFromCamera(time_s); }

bool IsFinite(const SE3d& pose) {
  const Quaterniond& q = pose.rotation;
  const Vec3d& t = pose.translation;
  return std::isfinite(q.w + q.x + q.y + q.z + t.x + t.y + t.z);
}

Frame CoveredLens(double time_s) {
  Frame frame = StudioFrame(time_s);
  for (Rgb8& pixel : frame.rgb) pixel = {};
  return frame;
}

// A gray wall that fills the picture, under noise: nothing to hold on to but the noise.
Frame TexturelessWall(double time_s) {
  Frame frame = StudioFrame(time_s);
  const CounterRandom random(5);
  for (std::size_t i = 0; i < frame.rgb.size(); ++i) {
    const auto gray = std::uint8_t(std::lround(128 + 2 * random.Normal(i)));
    frame.rgb.data()[i] = {gray, gray, gray};
    frame.depth_m.data()[i] = 1.5f;
  }
  return frame;
}

// In a mirror, where no pose explains it.
Frame Mirrored(double time_s) {
  Frame frame = StudioFrame(time_s);
  for (int y = 0; y < frame.rgb.height(); ++y) {
    std::reverse(frame.rgb.row(y), frame.rgb.row(y) + frame.rgb.width());
    std::reverse(frame.depth_m.row(y), frame.depth_m.row(y) + frame.depth_m.width());
  }
  return frame;
}

struct Disturbance {
  const char* name;
  Frame (*at)(double time_s);
};
void PrintTo(const Disturbance& disturbance, std::ostream* out) { *out << disturbance.name; }

class TrackingTrust : public testing::TestWithParam<std::tuple<const char*, Disturbance>> {
 protected:
  tracker::KeyframeTracker MakeOne() const {
    return MakeTracker(kCamera, {std::get<0>(GetParam()), "cpu", "sparse", 0}, TruePose(0.5));
  }
  static inline const PinholeCamera kCamera = SmallPictures().camera;
};

TEST_P(TrackingTrust, IsLostOnceAndBackAtOnce) {
  const std::string preset = std::get<0>(GetParam());
  tracker::KeyframeTracker tracker = MakeOne();
  SE3d last;
  for (const double time_s : {0.5, 0.55, 0.6}) {
    const TrackedFrame tracked = tracker.Track(StudioFrame(time_s));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << tracked.message;
    last = tracked.world_from_camera;
  }
  const TrackedFrame disturbed = tracker.Track(std::get<1>(GetParam()).at(0.65));
  EXPECT_TRUE(IsFinite(disturbed.world_from_camera));
  EXPECT_FALSE(disturbed.new_keyframe);
  if (preset == "paper") {
    EXPECT_NE(disturbed.status, TrackingStatus::kTracked);
  } else {
    EXPECT_EQ(disturbed.status, TrackingStatus::kLost) << disturbed.message;
    EXPECT_TRUE(Difference(disturbed.world_from_camera, last).Within({0, 1e-9}));
  }
  for (const double time_s : {0.7, 0.75}) {
    const TrackedFrame back = tracker.Track(StudioFrame(time_s));
    EXPECT_EQ(back.status, TrackingStatus::kTracked) << back.message;
    EXPECT_TRUE(Difference(back.world_from_camera, TruePose(time_s)).Within({0.01, 0.5}));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Studio, TrackingTrust,
    testing::Combine(testing::Values("paper", "accurate", "fast"),
                     testing::Values(Disturbance{"covered_lens", CoveredLens},
                                     Disturbance{"textureless_wall", TexturelessWall},
                                     Disturbance{"mirrored", Mirrored})),
    [](const auto& p) {
      return std::string(std::get<0>(p.param)) + "_" + std::get<1>(p.param).name;
    });

class OwnPresets : public testing::TestWithParam<const char*> {};

// From the path's one end to its other in no time, and back: whatever the tracker says it knows is
// true.
TEST_P(OwnPresets, AfterAJumpAPoseIsRightOrNone) {
  tracker::KeyframeTracker tracker =
      MakeTracker(SmallPictures().camera, {GetParam(), "cpu", "sparse", 0}, TruePose(0));
  int tracked = 0;
  for (const double time_s : {0.0, 0.05, 3.9, 3.95, 0.1, 2.0, 0.15}) {
    const TrackedFrame frame = tracker.Track(StudioFrame(time_s));
    EXPECT_TRUE(IsFinite(frame.world_from_camera));
    if (frame.status != TrackingStatus::kTracked) continue;
    ++tracked;
    EXPECT_TRUE(Difference(frame.world_from_camera, TruePose(time_s)).Within({0.01, 0.5}))
        << time_s
        << " s: " << Norm(frame.world_from_camera.translation - TruePose(time_s).translation);
  }
  EXPECT_GE(tracked, 4);  // those near the first at least
}

// Half a second without frames: the camera has gone on, and turned.
TEST_P(OwnPresets, DroppedFramesAreBridged) {
  tracker::KeyframeTracker tracker =
      MakeTracker(SmallPictures().camera, {GetParam(), "cpu", "sparse", 0}, TruePose(1));
  for (const double time_s : {1.0, 1.05, 1.1, 1.6, 2.2, 2.25}) {
    const TrackedFrame frame = tracker.Track(StudioFrame(time_s));
    EXPECT_EQ(frame.status, TrackingStatus::kTracked) << time_s << ": " << frame.message;
    EXPECT_TRUE(Difference(frame.world_from_camera, TruePose(time_s)).Within({0.01, 0.5}))
        << time_s;
  }
}

INSTANTIATE_TEST_SUITE_P(Studio, OwnPresets, testing::Values("accurate", "fast"));

}  // namespace
}  // namespace silt::experiments
