// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/coarse_initializer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "analytic_room.h"
#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/tracker/cpu_backend.h"

namespace silt::tracker {
namespace {

const SE3d kRoomFromKeyframe{Quaterniond::Exp({0.1, 0.4, -0.05}), {0.2, -0.1, 0.3}};

Keyframe RoomKeyframe() {
  Keyframe keyframe;
  keyframe.frame = RoomFrame(kRoomFromKeyframe);
  keyframe.intensity = GrayFromRgb(keyframe.frame.rgb);
  return keyframe;
}

InitialEstimate Estimate(const CoarseOptions& options, const SE3d& current_from_keyframe,
                         const SE3d& expected = {}, const Keyframe& keyframe = RoomKeyframe()) {
  const Frame current = RoomFrame(kRoomFromKeyframe * current_from_keyframe.Inverse());
  const Image<float> intensity = GrayFromRgb(current.rgb);
  CoarseInitializer initializer(MakeCpuBackend(), options);
  return initializer.Estimate({keyframe, current, intensity, kSmallCamera, 0, 1, expected});
}

TEST(CoarseInitializer, FindsALargeTurn) {
  for (const Vec3d& turn : {Vec3d{0, 0.2, 0}, Vec3d{-0.15, 0.05, 0}, Vec3d{0, 0, 0.2}}) {
    const SE3d truth = SE3d::Exp({turn, {}});
    const InitialEstimate estimate = Estimate(TurnAlone(), truth);
    ASSERT_TRUE(estimate.current_from_keyframe);
    EXPECT_LT(Angle(*estimate.current_from_keyframe, truth), 5e-3);
    EXPECT_GT(estimate.milliseconds, 0);
  }
}

// The expected translation is none of its business.
TEST(CoarseInitializer, KeepsTheExpectedTranslation) {
  const SE3d expected{Quaterniond::Exp({0.01, 0, 0}), {0.05, 0.02, -0.03}};
  const SE3d truth{Quaterniond::Exp({0.02, 0.12, 0}), expected.translation};
  const InitialEstimate estimate = Estimate(TurnAlone(), truth, expected);
  ASSERT_TRUE(estimate.current_from_keyframe);
  const SE3d& found = *estimate.current_from_keyframe;
  EXPECT_LT(Angle(found, truth), 5e-3);
  // Updates turn about the current camera: the camera's place stays, not the vector.
  EXPECT_LT(Norm(found.Inverse().translation - expected.Inverse().translation), 1e-9);
}

Frame DetailedFrame(const SE3d& room_from_camera) {
  const View view = RenderRoom(room_from_camera, kSmallCamera, DetailedPattern);
  Frame frame = RoomFrame(room_from_camera);
  for (std::size_t i = 0; i < view.intensity.size(); ++i) {
    const auto gray = std::uint8_t(std::lround(255 * view.intensity.data()[i]));
    frame.rgb.data()[i] = {gray, gray, gray};
  }
  return frame;
}

// In a room with detail, where one level of intensities alone is lost.
TEST(CoarseInitializer, ReachesFarFromAWideStart) {
  Keyframe keyframe;
  keyframe.frame = DetailedFrame(kRoomFromKeyframe);
  keyframe.intensity = GrayFromRgb(keyframe.frame.rgb);
  const auto error = [&](const CoarseOptions& options, const SE3d& truth) {
    const Frame current = DetailedFrame(kRoomFromKeyframe * truth.Inverse());
    const Image<float> intensity = GrayFromRgb(current.rgb);
    CoarseInitializer initializer(MakeCpuBackend(), options);
    const InitialEstimate found =
        initializer.Estimate({keyframe, current, intensity, kSmallCamera, 0, 1});
    return Distance(found.current_from_keyframe.value_or(SE3d{}), truth);
  };
  CoarseOptions narrow;
  narrow.stages.emplace_back().max_iterations = {100};
  for (const Twistd& far : {Twistd{{0.12, 0.1, 0}, {0.1, -0.1, 0.1}},
                            Twistd{{-0.05, -0.2, 0.05}, {-0.15, 0.1, 0.05}}}) {
    EXPECT_LT(error(WideStart(), SE3d::Exp(far)), 0.01);
    EXPECT_GT(error(narrow, SE3d::Exp(far)), 0.05);
  }
}

struct KnowingInitializer : Initializer {
  explicit KnowingInitializer(const SE3d& pose) : answer(pose) {}
  InitialEstimate Estimate(const InitializerInput&) override { return {answer, 50, 40, 1.5}; }
  SE3d answer;
};

// A quarter turn about the optical axis: out of reach, unless another initializer knows of it.
TEST(CoarseInitializer, TriesWhatAnotherInitializerOffers) {
  const SE3d truth = SE3d::Exp({{0, 0, 1.5}, {0.05, 0, 0}});
  const SE3d nearly = SE3d::Exp({{0.02, -0.02, 0}, {0, 0.03, 0}}) * truth;
  const Keyframe keyframe = RoomKeyframe();
  const Frame current = RoomFrame(kRoomFromKeyframe * truth.Inverse());
  const Image<float> intensity = GrayFromRgb(current.rgb);
  const auto found = [&](std::unique_ptr<Initializer> other) {
    CoarseInitializer initializer(MakeCpuBackend(), WideStart(), std::move(other));
    return initializer.Estimate({keyframe, current, intensity, kSmallCamera, 0, 1});
  };
  const InitialEstimate estimate = found(std::make_unique<KnowingInitializer>(nearly));
  ASSERT_TRUE(estimate.current_from_keyframe);
  EXPECT_LT(Distance(*estimate.current_from_keyframe, truth), 0.01);
  EXPECT_EQ(estimate.inliers, 40);
  EXPECT_GT(estimate.milliseconds, 1.5);
  EXPECT_GT(Angle(found(nullptr).current_from_keyframe.value_or(SE3d{}), truth), 0.1);
}

TEST(CoarseInitializer, OffersNothingThatIsNoBetterThanWhatIsExpected) {
  const SE3d truth = SE3d::Exp({{0.1, 0, 0}, {}});
  EXPECT_FALSE(Estimate(TurnAlone(), SE3d{}).current_from_keyframe);
  Keyframe blind = RoomKeyframe();
  blind.frame.depth_m = Image<float>(kSmallCamera.width, kSmallCamera.height);
  EXPECT_FALSE(Estimate(TurnAlone(), truth, {}, blind).current_from_keyframe);
  blind.frame.depth_m = {};
  EXPECT_FALSE(Estimate(TurnAlone(), truth, {}, blind).current_from_keyframe);
  CoarseOptions tiny = TurnAlone();
  tiny.max_width = 8;  // and so 6 high
  EXPECT_FALSE(Estimate(tiny, truth).current_from_keyframe);
}

TEST(CoarseInitializer, RejectsOptionsOutOfRange) {
  EXPECT_THROW(CoarseInitializer(MakeCpuBackend(), {}), Error);
  CoarseOptions options = TurnAlone();
  options.max_width = 7;
  EXPECT_THROW(CoarseInitializer(MakeCpuBackend(), options), Error);
  options = WideStart();
  options.turns_rad.clear();
  EXPECT_THROW(CoarseInitializer(MakeCpuBackend(), options), Error);
}

}  // namespace
}  // namespace silt::tracker
