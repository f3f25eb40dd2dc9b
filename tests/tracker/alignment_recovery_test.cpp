// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "analytic_room.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"

// Perturb the true pose along one axis, and recover it, on images that are exact.
namespace silt::tracker {
namespace {

const SE3d kReferencePose{Quaterniond::Exp({0.1, 0.4, -0.05}), {0.2, -0.1, 0.3}};
const SE3d kCurrentFromReference = SE3d::Exp({{0.02, -0.03, 0.01}, {0.04, -0.02, 0.03}});

AlignmentResult AlignRoom(const SE3d& initial, const AlignmentOptions& options = {},
                          float (*pattern)(const Vec3d&) = RoomPattern) {
  const std::unique_ptr<Backend> backend = MakeCpuBackend();
  const View reference = RenderRoom(kReferencePose, kSmallCamera, pattern);
  const View current =
      RenderRoom(kReferencePose * kCurrentFromReference.Inverse(), kSmallCamera, pattern);
  const auto pyramid = backend->MakeReference(reference.intensity, reference.depth_m, kSmallCamera,
                                              {options.levels()});
  const auto current_pyramid = backend->MakeCurrent(current.intensity, {}, {options.levels()});
  return Align(*backend, {*pyramid, *current_pyramid}, initial, options);
}

class PerturbedAxis : public testing::TestWithParam<int> {};

// Axes 0…5 are ω and v; each in both directions.
TEST_P(PerturbedAxis, IsRecovered) {
  for (const double sign : {-1.0, 1.0}) {
    double xi[6] = {};
    xi[GetParam()] = sign * (GetParam() < 3 ? 0.06 : 0.15);
    const SE3d error = SE3d::Exp({{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}});
    AlignmentOptions options;
    options.max_iterations = {20, 20, 20, 20};
    const AlignmentResult result = AlignRoom(error * kCurrentFromReference, options);
    ASSERT_TRUE(result.ok) << result.failure;
    // Bilinear interpolation of 160×120 pixels costs what is left: far below a hundredth of a
    // pixel.
    EXPECT_LT(Distance(result.current_from_reference, kCurrentFromReference), 3e-4);
    EXPECT_LT(Angle(result.current_from_reference, kCurrentFromReference), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Twist, PerturbedAxis, testing::Range(0, 6));

TEST(AlignmentRecovery, ThePapersIterationsSuffice) {
  const AlignmentResult result = AlignRoom(SE3d{});
  ASSERT_TRUE(result.ok) << result.failure;
  EXPECT_LT(Distance(result.current_from_reference, kCurrentFromReference), 1e-3);
  EXPECT_LT(Angle(result.current_from_reference, kCurrentFromReference), 3e-4);
}

TEST(AlignmentRecovery, ThePyramidReachesFartherThanOneLevel) {
  const SE3d start = SE3d::Exp({{0.06, 0.06, 0}, {}}) * kCurrentFromReference;
  const auto error = [&](const std::vector<int>& max_iterations) {
    AlignmentOptions options;
    options.max_iterations = max_iterations;
    return Angle(AlignRoom(start, options, DetailedPattern).current_from_reference,
                 kCurrentFromReference);
  };
  EXPECT_LT(error({20, 20, 20, 20}), 1e-3);
  EXPECT_GT(error({200}), 1e-2);
}

// The equations of the last pose are there: one more step from them goes on where the iterations
// end, and goes the whole way although weighted squares fall short.
TEST(AlignmentRecovery, TheLastEquationsGiveOneMoreStep) {
  const SE3d start = SE3d::Exp({{0.003, -0.002, 0}, {0.005, 0.003, 0}}) * kCurrentFromReference;
  AlignmentOptions options;
  options.robust_scale = 2.5;
  options.max_iterations = {40};
  options.min_update_norm = 1e-10;
  const SE3d converged = AlignRoom(start, options).current_from_reference;
  const auto rest = [&](bool take_last_step) {
    options.max_iterations = {2};
    options.take_last_step = take_last_step;
    return Distance(AlignRoom(start, options).current_from_reference, converged);
  };
  EXPECT_GT(rest(false), 1e-6);
  EXPECT_LT(rest(true), 0.4 * rest(false));
}

// A board moves before the wall, and hides one side of it: what the reference shows there is no
// residual of the pose.
TEST(AlignmentRecovery, HiddenPixelsDoNotPullThePose) {
  const SE3d current_from_reference = SE3d::Exp({{0, 0.02, 0}, {0.12, 0.03, 0}});
  const SE3d start = SE3d::Exp({{0.004, -0.004, 0}, {-0.02, 0.01, 0.01}}) * current_from_reference;
  const std::unique_ptr<Backend> backend = MakeCpuBackend();
  const View reference = RenderRoomWithBoard({});
  const View current = RenderRoomWithBoard(current_from_reference.Inverse());
  const auto error = [&](bool exclude_hidden) {
    AlignmentOptions options;
    options.max_iterations = {10, 10, 20};
    options.exclude_hidden = exclude_hidden;
    const auto pyramid = backend->MakeReference(reference.intensity, reference.depth_m,
                                                kSmallCamera, {options.levels()});
    const auto current_pyramid = backend->MakeCurrent(current.intensity, {}, {options.levels()});
    const AlignmentResult result = Align(*backend, {*pyramid, *current_pyramid}, start, options);
    EXPECT_TRUE(result.ok) << result.failure;
    return Distance(result.current_from_reference, current_from_reference);
  };
  // What is left comes of the board's own edges, as coarse as this image is.
  EXPECT_LT(error(true), 6e-3);
  EXPECT_GT(error(false), 1e-2);
}

AlignmentOptions RobustOptions() {
  AlignmentOptions options = AccuratePreset().alignment;
  options.max_iterations = {20, 20, 20};
  options.depth_edge_margin_px = 1;  // of a small image
  return options;
}

// The board again, with a lamp of the room switched off in one corner of the current image.
TEST(AlignmentRecovery, RobustWeightsDoNotHeedWhatChanged) {
  const SE3d current_from_reference = SE3d::Exp({{0, 0.02, 0}, {0.12, 0.03, 0}});
  const SE3d start = SE3d::Exp({{0.004, -0.004, 0}, {-0.02, 0.01, 0.01}}) * current_from_reference;
  const std::unique_ptr<Backend> backend = MakeCpuBackend();
  const View reference = RenderRoomWithBoard({});
  View current = RenderRoomWithBoard(current_from_reference.Inverse());
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) current.intensity(x, y) *= 0.4f;
  }
  const auto error = [&](const AlignmentOptions& options) {
    const auto pyramid = backend->MakeReference(reference.intensity, reference.depth_m,
                                                kSmallCamera, options.Pyramids());
    const auto current_pyramid =
        backend->MakeCurrent(current.intensity, current.depth_m, options.Pyramids());
    const AlignmentResult result = Align(*backend, {*pyramid, *current_pyramid}, start, options);
    EXPECT_TRUE(result.ok) << result.failure;
    return Distance(result.current_from_reference, current_from_reference);
  };
  AlignmentOptions squares = RobustOptions();
  squares.robust_scale = squares.robust_gradient = 0;
  squares.depth_residual = false;
  EXPECT_LT(error(RobustOptions()), 2e-3);
  EXPECT_GT(error(squares), 5e-3);
}

// Two references, each in its own frame, and an anchor that is neither.
TEST(AlignmentRecovery, SeveralReferencesDetermineOnePose) {
  const SE3d room_from_anchor = kReferencePose, current_from_anchor = kCurrentFromReference;
  const SE3d anchor_from_reference[2] = {SE3d::Exp({{0.02, -0.03, 0.01}, {0.05, 0.02, -0.04}}),
                                         SE3d::Exp({{-0.03, 0.01, 0.02}, {-0.04, 0.03, 0.03}})};
  const std::unique_ptr<Backend> backend = MakeCpuBackend();
  const AlignmentOptions options = RobustOptions();
  std::vector<std::unique_ptr<ReferencePyramid>> pyramids;
  ReferenceViews views;
  for (const SE3d& pose : anchor_from_reference) {
    const View view = RenderRoom(room_from_anchor * pose, kSmallCamera);
    pyramids.push_back(
        backend->MakeReference(view.intensity, view.depth_m, kSmallCamera, options.Pyramids()));
    views.push_back({*pyramids.back(), pose});
  }
  const View current = RenderRoom(room_from_anchor * current_from_anchor.Inverse(), kSmallCamera);
  const auto current_pyramid =
      backend->MakeCurrent(current.intensity, current.depth_m, options.Pyramids());
  const SE3d start = SE3d::Exp({{0.02, 0.01, -0.01}, {0.03, -0.02, 0.04}}) * current_from_anchor;
  const AlignmentResult result = Align(*backend, views, *current_pyramid, start, options);
  ASSERT_TRUE(result.ok) << result.failure;
  EXPECT_LT(Distance(result.current_from_reference, current_from_anchor), 3e-4);
  EXPECT_LT(Angle(result.current_from_reference, current_from_anchor), 1e-4);
}

TEST(AlignmentRecovery, CostsFallAtEveryLevel) {
  for (const AlignmentLevel& level : AlignRoom(SE3d{}).levels) {
    EXPECT_LE(level.final_cost.mean(), level.initial_cost.mean()) << level.level;
  }
}

TEST(AlignmentRecovery, AViewOfAnotherWallIsAFailure) {
  const AlignmentResult result = AlignRoom(SE3d{Quaterniond::Exp({0, 2.5, 0}), {}});
  EXPECT_FALSE(result.ok);
  EXPECT_NE(result.failure, "");
}

}  // namespace
}  // namespace silt::tracker
