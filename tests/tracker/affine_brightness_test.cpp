// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_reduction.h"
#include "silt/tracker/pixel_sums.h"
#include "small_walk.h"

// Images of different exposures: I → gain·I + offset.
namespace silt::tracker {
namespace {

const SE3d kMotion = SE3d::Exp({{0.02, -0.03, 0.01}, {0.04, -0.02, 0.03}});

Image<float> Exposed(Image<float> image, const Brightness& brightness) {
  for (float& i : image) i = float(brightness.gain * i + brightness.offset);
  return image;
}

TEST(FitBrightness, SolvesForWhatThePixelsHave) {
  // r = 0.3·I − 0.1 with weights of any size.
  double sums[kBrightnessSumCount] = {};
  for (int k = 0; k < 50; ++k) {
    const double i = 0.02 * k, w = 1 + k % 3, r = 0.3 * i - 0.1;
    const double terms[] = {w, w * i, w * i * i, w * r, w * r * i};
    for (int n = 0; n < kBrightnessSumCount; ++n) sums[n] += terms[n];
  }
  const Brightness fitted = FitBrightness(sums, {0.9, 0.05});
  EXPECT_NEAR(fitted.gain, 1.2, 1e-12);
  EXPECT_NEAR(fitted.offset, -0.05, 1e-12);
}

TEST(FitBrightness, KeepsTheGainOfWhatHasOneIntensity) {
  const double i = 0.5, r = 0.1, n = 1000;
  const double sums[] = {n, n * i, n * i * i, n * r, n * r * i};
  const Brightness fitted = FitBrightness(sums, {1.5, 0});
  EXPECT_EQ(fitted.gain, 1.5);
  EXPECT_NEAR(fitted.offset, 0.1, 1e-12);
  const double nothing[kBrightnessSumCount] = {};
  EXPECT_EQ(FitBrightness(nothing, {1.5, 0.2}), (Brightness{1.5, 0.2}));
}

// A gain near 0 would explain any picture.
TEST(FitBrightness, BoundsTheGain) {
  double sums[kBrightnessSumCount] = {};
  for (const double i : {0.1, 0.5, 0.9}) {
    const double terms[] = {1, i, i * i, -i, -i * i};
    for (int n = 0; n < kBrightnessSumCount; ++n) sums[n] += terms[n];
  }
  EXPECT_EQ(FitBrightness(sums, {1, 0}).gain, 0.05);
}

struct Levels {
  View reference = RenderRoom({}), current = RenderRoom(kMotion.Inverse());

  NormalEquations Equations(const ResidualNorm& norm, SimdLevel level = BestSimdLevel()) const {
    return CpuReduction(level).Equations(
        {kSmallCamera, reference.intensity, reference.depth_m, current.intensity}, kMotion, norm);
  }
};

ResidualNorm Robust(const Brightness& brightness) {
  ResidualNorm norm;
  norm.intensity = {8.0 / 255, 0.05, 1};
  norm.brightness = brightness;
  norm.fit_brightness = true;
  return norm;
}

TEST(AffineBrightness, IsThatOfTheReference) {
  const Brightness brightness{0.7, 0.1};
  Levels levels;
  const NormalEquations actual = levels.Equations(Robust(brightness));
  levels.reference.intensity = Exposed(levels.reference.intensity, brightness);
  const NormalEquations expected = levels.Equations(Robust({}));
  EXPECT_NEAR(actual.cost.sum, expected.cost.sum, 1e-5 * expected.cost.sum);
  for (int k = 0; k < 21; ++k) {
    EXPECT_NEAR(actual.hessian[k], expected.hessian[k], 1e-5 * expected.hessian[0]) << k;
  }
}

// The derivatives of the cost by the two parameters, where all weights are 1: −Σr·I and −Σr, by
// central differences of the cost itself. At what is fitted they are 0.
TEST(AffineBrightness, FitsWhereTheCostIsLeast) {
  Levels levels;
  levels.current.intensity = Exposed(levels.current.intensity, {1.2, -0.05});
  const auto cost = [&](double gain, double offset) {
    ResidualNorm norm;
    norm.intensity.scale = 100;  // all but squares
    norm.brightness = {gain, offset};
    return levels.Equations(norm).cost.sum;
  };
  ResidualNorm norm;
  norm.intensity.scale = 100;
  norm.fit_brightness = true;
  const Brightness b = levels.Equations(norm).brightness;
  EXPECT_NEAR(b.gain, 1.2, 0.01);
  EXPECT_NEAR(b.offset, -0.05, 0.01);
  const double h = 0.01, least = cost(b.gain, b.offset);
  const double by_gain = cost(b.gain + h, b.offset) - cost(b.gain - h, b.offset);
  const double by_offset = cost(b.gain, b.offset + h) - cost(b.gain, b.offset - h);
  EXPECT_LT(std::abs(by_gain), 1e-3 * (cost(b.gain + h, b.offset) - least));
  EXPECT_LT(std::abs(by_offset), 1e-3 * (cost(b.gain, b.offset + h) - least));
}

TEST(AffineBrightness, HasTheSameBitsAtEverySimdLevel) {
  const Levels levels;
  const NormalEquations expected = levels.Equations(Robust({0.9, 0.02}));
  EXPECT_NE(expected.brightness, (Brightness{0.9, 0.02}));
  for (const SimdLevel level : SupportedSimdLevels()) {
    EXPECT_EQ(levels.Equations(Robust({0.9, 0.02}), level), expected);
  }
}

AlignmentOptions Options(bool affine_brightness) {
  AlignmentOptions options = AccuratePreset().alignment;
  options.max_iterations = {20, 20, 20};
  options.depth_residual = options.use_current_depth = false;
  options.affine_brightness = affine_brightness;
  return options;
}

// Two keyframes, each with an exposure of its own.
TEST(AffineBrightness, DoesNotPullThePose) {
  const auto backend = MakeCpuBackend();
  const SE3d first, second{{}, {0.05, 0, 0}};  // anchor_from_reference
  const auto error = [&](bool affine_brightness) {
    const AlignmentOptions options = Options(affine_brightness);
    const auto make = [&](const SE3d& room_from_camera, const Brightness& brightness) {
      const View view = RenderRoom(room_from_camera);
      return backend->MakeReference(Exposed(view.intensity, brightness), view.depth_m, kSmallCamera,
                                    options.Pyramids());
    };
    const auto a = make(first, {0.8, 0.05}), b = make(second, {1.1, -0.1});
    const View view = RenderRoom(kMotion.Inverse());
    const auto current = backend->MakeCurrent(view.intensity, {}, options.Pyramids());
    const AlignmentResult result =
        Align(*backend, {{*a, first}, {*b, second}}, *current,
              SE3d::Exp({{0.01, 0, 0}, {0, 0.02, 0}}) * kMotion, options);
    EXPECT_TRUE(result.ok) << result.failure;
    if (affine_brightness) {
      EXPECT_NEAR(result.brightness.gain, 1 / 0.8, 0.01);
      EXPECT_NEAR(result.brightness.offset, -0.05 / 0.8, 0.01);
    }
    return Distance(result.current_from_reference, kMotion);
  };
  EXPECT_LT(error(true), 1e-3);
  EXPECT_GT(error(false), 5 * error(true));
}

Frame ExposedFrame(int i, double gain) {
  Frame frame = RoomFrame(TruePose(i), 0.1 * i);
  for (Rgb8& c : frame.rgb) {
    const auto gray = std::uint8_t(std::lround(gain * c.r));
    c = {gray, gray, gray};
  }
  return frame;
}

// Frames that grow darker, in the tracker; and none at all, which no gain makes a match.
TEST(AffineBrightness, IsTrustedUnlessThePictureIsGone) {
  TrackerOptions options = AccuratePreset();
  options.alignment.max_iterations.pop_back();
  options.alignment.affine_brightness = true;
  KeyframeTracker tracker = MakeTracker(nullptr, options);
  for (int i = 0; i < 12; ++i) {
    const TrackedFrame tracked = tracker.Track(ExposedFrame(i, 1 - 0.05 * i));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracked) << i << ": " << tracked.message;
    EXPECT_LT(Distance(tracked.world_from_camera, TruePose(i)), 6e-3) << i;
  }
  EXPECT_EQ(tracker.Track(ExposedFrame(12, 0)).status, TrackingStatus::kLost);
}

}  // namespace
}  // namespace silt::tracker
