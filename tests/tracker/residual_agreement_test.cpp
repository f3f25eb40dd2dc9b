// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT

// Colours that are registered to their depths, and colours that are not.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "analytic_room.h"
#include "silt/core/random.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/keyframe_tracker.h"

namespace silt::tracker {
namespace {

constexpr PinholeCamera kCamera{240.6, 240, 159.5, 119.5, 320, 240};

// The intensity is that of a camera of another focal length.
View Render(const SE3d& room_from_camera, double colour_zoom, std::uint64_t stream) {
  PinholeCamera colour = kCamera;
  colour.fx *= colour_zoom;
  colour.fy *= colour_zoom;
  View view{RenderRoom(room_from_camera, colour).intensity,
            RenderRoom(room_from_camera, kCamera).depth_m};
  const CounterRandom random(7, stream);
  for (std::size_t i = 0; i < view.depth_m.size(); ++i) {
    float& z = view.depth_m.data()[i];
    z = float(1 / (1 / double(z) + 2e-3 * random.Normal(2 * i)));
    view.intensity.data()[i] += float(0.004 * random.Normal(2 * i + 1));
  }
  return view;
}

// Ten times the mean of χ² where noise alone parts both kinds.
constexpr double kBound = 60;

// Root mean square over some motions, in metres.
double Error(double colour_zoom, double max_disagreement) {
  AlignmentOptions options = AccuratePreset().alignment;
  options.max_disagreement = max_disagreement;
  options.registered_contrast = 0;  // whatever the edges tell, of which this room has none
  const auto backend = MakeCpuBackend();
  double squares = 0;
  for (int seed = 0; seed < 6; ++seed) {
    const SE3d reference{Quaterniond::Exp({0.1, 0.3, 0}), {0.1, 0, -0.4}};
    const SE3d current =
        reference * SE3d::Exp({{0.02, 0.04 + 0.004 * seed, 0.01}, {0.03, -0.02, 0.01 * seed}});
    const View a = Render(reference, colour_zoom, std::uint64_t(2 * seed));
    const View b = Render(current, colour_zoom, std::uint64_t(2 * seed + 1));
    const auto keyframe =
        backend->MakeReference(a.intensity, a.depth_m, kCamera, options.Pyramids());
    const auto frame = backend->MakeCurrent(b.intensity, b.depth_m, options.Pyramids());
    const SE3d truth = current.Inverse() * reference;
    const SE3d found = Align(*backend, {*keyframe, *frame}, truth, options).current_from_reference;
    squares += std::pow(Distance(found, truth), 2) / 6;
  }
  return std::sqrt(squares);
}

TEST(ResidualAgreement, ColoursOfAnotherFocalLengthLoseWeight) {
  EXPECT_LT(Error(0.9, kBound), 0.7 * Error(0.9, 0));
}

TEST(ResidualAgreement, RegisteredColoursKeepIt) { EXPECT_EQ(Error(1, kBound), Error(1, 0)); }

constexpr PinholeCamera kBoardCamera{481.2, 480, 319.5, 239.5, 640, 480};

// A board before the walls, as a tracker gets it: its edges tell whether colours are registered.
Frame BoardFrame(const SE3d& room_from_camera, double colour_zoom, double time_s) {
  PinholeCamera colour = kBoardCamera;
  colour.fx *= colour_zoom;
  colour.fy *= colour_zoom;
  const View seen = RenderRoomWithBoard(room_from_camera, colour, RoomPattern);
  Frame frame{time_s, Image<Rgb8>(kBoardCamera.width, kBoardCamera.height),
              RenderRoomWithBoard(room_from_camera, kBoardCamera).depth_m};
  for (std::size_t i = 0; i < seen.intensity.size(); ++i) {
    const auto gray = std::uint8_t(std::lround(255 * seen.intensity.data()[i]));
    frame.rgb.data()[i] = {gray, gray, gray};
  }
  return frame;
}

constexpr int kFrames = 3;

SE3d TruthOf(int frame) {
  return SE3d::Exp(
      {{0.01 * frame, 0.02 * frame, 0.01 * frame}, {0.02 * frame, -0.01 * frame, 0.02 * frame}});
}

std::vector<Frame> BoardFrames(double colour_zoom) {
  const SE3d first{Quaterniond::Exp({0.05, 0.1, 0}), {0, 0, -0.6}};
  std::vector<Frame> frames;
  for (int i = 0; i < kFrames; ++i) {
    frames.push_back(BoardFrame(first * TruthOf(i), colour_zoom, 0.1 * i));
  }
  return frames;
}

// In metres, where every frame becomes a keyframe.
double TrackedError(const std::vector<Frame>& frames, TrackerOptions options) {
  options.keyframes.max_distance_m = 0.01;
  KeyframeTracker tracker(kBoardCamera, options, MakeCpuBackend(), nullptr);
  TrackedFrame last;
  for (const Frame& frame : frames) {
    last = tracker.Track(frame);
    EXPECT_NE(last.status, TrackingStatus::kLost) << last.message;
    EXPECT_TRUE(last.new_keyframe);
  }
  return Distance(last.world_from_camera, TruthOf(kFrames - 1));
}

TEST(ResidualAgreement, TrackersLookWhereColoursAreNotRegistered) {
  const std::vector<Frame> registered = BoardFrames(1), not_registered = BoardFrames(0.9);
  for (const TrackerOptions& preset : {FastPreset(), AccuratePreset()}) {
    TrackerOptions never = preset;
    never.alignment.max_disagreement = 0;
    EXPECT_LT(TrackedError(not_registered, preset), 0.5 * TrackedError(not_registered, never));
    EXPECT_EQ(TrackedError(registered, preset), TrackedError(registered, never));
    // Nor are keyframes polished, which would let intensities count in full.
    TrackerOptions unpolished = preset;
    unpolished.keyframes.polish_iterations = 0;
    EXPECT_EQ(TrackedError(not_registered, preset), TrackedError(not_registered, unpolished));
  }
}

// Two kinds with H = 1000·I whose gradients alone lead to `apart` of the first parameter, and whose
// stripes scatter by `kappa` thousandths: 1e-3 is what noise alone leaves.
double Share(double apart, double intensity_kappa, double depth_kappa) {
  ResidualAgreement agreement;
  agreement.Begin({});
  while (!agreement.done()) {
    const double kappa = agreement.of_depth() ? depth_kappa : intensity_kappa;
    const double x = agreement.pose().Log().omega.x;
    NormalEquations equations;
    for (const int k : {0, 6, 11, 15, 18, 20}) {
      equations.hessian[k] = 1000;
      equations.scatter[k] = 1e6 * kappa * (kScatterStripes - 1) / kScatterStripes;
    }
    equations.gradient[0] = 1000 * (agreement.of_depth() ? x : x - apart);
    agreement.Take(equations);
  }
  return agreement.IntensityShare(20);
}

TEST(ResidualAgreement, BlamesTheIntensities) {
  const double apart = 0.5;
  // χ² = 0.5²/(κ_I + κ_Z), all in units of what Share() takes for 1.
  EXPECT_EQ(Share(apart, 10e-3, 3e-3), 0);
  // f·κ_I + κ_Z = 0.5²/6, by steps of a quarter; whichever kind contradicts itself more.
  for (const auto& [intensity, depth] : {std::pair{4e-3, 2e-3}, {2e-3, 4e-3}}) {
    const double factor = depth / intensity / Share(apart, intensity, depth);
    const double wanted = (apart * apart / 6 - depth) / intensity;
    EXPECT_GT(factor, wanted * 0.99);
    EXPECT_LT(factor, wanted * 1.26);
  }
}

// What scatters less than its noise does so by chance, or because it is exact.
TEST(ResidualAgreement, TakesNothingForBetterThanItsNoise) {
  EXPECT_EQ(Share(0.5, 1e-9, 1e-9), Share(0.5, 1e-3, 1e-3));
  EXPECT_GT(Share(0.5, 1e-9, 1e-9), 0);
}

}  // namespace
}  // namespace silt::tracker
