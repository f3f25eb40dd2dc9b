// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/cpu_backend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analytic_room.h"
#include "silt/core/parallel.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/robust_norm.h"
#include "silt/tracker/kernel/sums.h"

namespace silt::tracker {
namespace {

const SE3d kMotion = SE3d::Exp({{0.02, -0.03, 0.05}, {0.05, -0.02, 0.04}});

// A pair of views and the pyramids that a backend makes of them.
struct Pair {
  View reference, current;
  PinholeCamera camera;
  int levels;
  std::unique_ptr<Backend> backend = MakeCpuBackend();
  std::unique_ptr<ReferencePyramid> reference_pyramid =
      backend->MakeReference(reference.intensity, reference.depth_m, camera, {levels});
  std::unique_ptr<CurrentPyramid> current_pyramid =
      backend->MakeCurrent(current.intensity, {}, {levels});

  NormalEquations Linearize(const SE3d& pose, int level = 0) const {
    return backend->Linearize({*reference_pyramid, *current_pyramid}, level, pose);
  }
  PhotometricCost Cost(const SE3d& pose, int level = 0) const {
    return backend->Cost({*reference_pyramid, *current_pyramid}, level, pose);
  }
};

Pair RoomPair(const PinholeCamera& camera = kSmallCamera, int levels = 4) {
  return {RenderRoom({}, camera), RenderRoom(kMotion.Inverse(), camera), camera, levels};
}

PinholeCamera CameraOfSize(int width, int height) {
  return {100, 100, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
}

// The kernels in double precision, one pixel after the other.
kernel::Sums<double> SumInDouble(const Pair& pair, const SE3d& pose) {
  const kernel::Warp<double> warp(pose, pair.camera);
  const kernel::ImageSampler<double> sampler{pair.current.intensity.data(), pair.camera.width,
                                             pair.camera.height};
  kernel::Sums<double> sums;
  for (int y = 0; y < pair.camera.height; ++y) {
    for (int x = 0; x < pair.camera.width; ++x) {
      sums.Add(kernel::Linearize<double>(
          warp, sampler,
          {double(x), double(y), pair.reference.depth_m(x, y), pair.reference.intensity(x, y)}));
    }
  }
  return sums;
}

class CpuBackendSizes : public testing::TestWithParam<std::pair<int, int>> {};

// Widths that do and do not divide by the lanes of a batch, heights that do not by those of a tile.
TEST_P(CpuBackendSizes, AgreesWithDoublePrecision) {
  const Pair pair = RoomPair(CameraOfSize(GetParam().first, GetParam().second), 1);
  const SE3d pose = SE3d::Exp({{0.004, 0.003, -0.002}, {0.01, -0.01, 0.02}}) * kMotion;
  const kernel::Sums<double> expected = SumInDouble(pair, pose);
  const NormalEquations actual = pair.Linearize(pose);
  // A pixel may change sides of the image's border by rounding.
  EXPECT_NEAR(double(actual.cost.pixels), expected.cost.count, 2);
  const double tolerance = 5e-3 / std::max(1.0, expected.cost.count) + 2e-5;
  EXPECT_NEAR(actual.cost.sum, 0.5 * expected.cost.squares, tolerance * expected.cost.squares);
  const int diagonal[6] = {0, 6, 11, 15, 18, 20};
  for (int i = 0; i < 6; ++i) {
    const double h = expected.hessian[diagonal[i]];
    EXPECT_NEAR(actual.hessian[diagonal[i]], h, tolerance * h) << i;
    EXPECT_NEAR(actual.gradient[i], expected.gradient[i],
                tolerance * std::sqrt(h * expected.cost.squares))
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Odd, CpuBackendSizes,
                         testing::Values(std::pair{160, 120}, std::pair{161, 119}, std::pair{67, 9},
                                         std::pair{18, 17}, std::pair{3, 40}));

TEST(CpuBackend, CostAndLinearizationGiveTheSameCost) {
  const Pair pair = RoomPair();
  for (int level = 0; level < 4; ++level) {
    EXPECT_EQ(pair.Cost(kMotion, level), pair.Linearize(kMotion, level).cost) << level;
  }
}

// ∂(½Σr²)/∂ξ = Jᵀr, by central differences of the cost itself.
TEST(CpuBackend, TheGradientIsThatOfTheCost) {
  const Pair pair = RoomPair();
  const SE3d pose = SE3d::Exp({{0.01, -0.01, 0.005}, {0.02, 0.01, -0.02}}) * kMotion;
  const NormalEquations equations = pair.Linearize(pose);
  for (int i = 0; i < 6; ++i) {
    const double step = 1e-3;
    const auto cost_at = [&](double s) {
      double xi[6] = {};
      xi[i] = s;
      return pair.Cost(SE3d::Exp({{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}}) * pose);
    };
    const PhotometricCost up = cost_at(step), down = cost_at(-step);
    // Pixels come and go at the border: compare what a pixel costs on average.
    const double numeric = (up.mean() - down.mean()) / (2 * step);
    const double analytic = equations.gradient[i] / double(equations.cost.pixels);
    EXPECT_NEAR(analytic, numeric, 0.05 * std::abs(numeric) + 2e-4) << i;
  }
}

// Pixel after pixel in double precision, each with its weight.
TEST(CpuBackend, RobustEquationsAreTheWeightedSums) {
  const Pair pair = RoomPair(kSmallCamera, 1);
  const SE3d pose = SE3d::Exp({{0.004, 0.003, -0.002}, {0.01, -0.01, 0.02}}) * kMotion;
  const ResidualNorm norm{{0.02, 0.01}, {}, false, {}};
  const kernel::RobustNorm<double> bounds{1 / (0.02 * 0.02), 1 / (0.01 * 0.01)};
  const kernel::Warp<double> warp(pose, pair.camera);
  const kernel::ImageSampler<double> sampler{pair.current.intensity.data(), 160, 120};
  kernel::Sums<double> weighted;
  double cost = 0, squares = 0;
  for (int i = 0; i < 160 * 120; ++i) {
    const int x = i % 160, y = i / 160;
    kernel::LinearizedResidual<double> pixel = kernel::Linearize<double>(
        warp, sampler,
        {double(x), double(y), pair.reference.depth_m(x, y), pair.reference.intensity(x, y)});
    const auto weight = kernel::Weigh(bounds, pixel.residual, pixel.gradient_squared);
    cost += 0.5 * weight.s * pixel.residual * pixel.residual;
    squares += pixel.residual * pixel.residual;
    for (double& j : pixel.jacobian) j *= weight.root;
    pixel.residual *= weight.root;
    weighted.Add(pixel);
  }
  const NormalEquations actual =
      pair.backend->Linearize({*pair.reference_pyramid, *pair.current_pyramid}, 0, pose, norm);
  EXPECT_LT(cost, 0.4 * squares);  // the norm matters here
  EXPECT_NEAR(actual.cost.sum, cost, 1e-4 * cost);
  EXPECT_NEAR(actual.cost.squares, squares, 1e-4 * squares);
  for (int k = 0; k < 21; ++k) {
    EXPECT_NEAR(actual.hessian[k], weighted.hessian[k], 1e-4 * weighted.hessian[0]) << k;
  }
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(actual.gradient[k], weighted.gradient[k],
                1e-3 * std::sqrt(weighted.hessian[0] * squares))
        << k;
  }
}

// Both kinds of residuals, each with its weight: depth alone knows of a step along the view of a
// plain wall, and the gradient is that of the cost.
TEST(CpuBackend, DepthResidualsAddTheirShare) {
  const Pair pair = RoomPair(kSmallCamera, 1);
  const SE3d pose = SE3d::Exp({{0.004, 0.003, -0.002}, {0.01, -0.01, 0.02}}) * kMotion;
  const auto current =
      pair.backend->MakeCurrent(pair.current.intensity, pair.current.depth_m, {1, 0, true});
  const auto linearize = [&](const SE3d& at, double weight) {
    const ResidualNorm norm{{0, 0}, {0, 0, weight}, true, {}};
    return pair.backend->Linearize({*pair.reference_pyramid, *current}, 0, at, norm);
  };
  const NormalEquations both = linearize(pose, 9), intensity = linearize(pose, 0);
  EXPECT_EQ(intensity.cost.sum, pair.Linearize(pose).cost.sum);
  EXPECT_GT(both.inverse_depth.count, 160 * 120 / 2);
  EXPECT_NEAR(both.cost.sum - intensity.cost.sum, 4.5 * both.inverse_depth.squares,
              1e-9 * both.cost.sum);
  for (int i = 0; i < 6; ++i) {
    const double step = 1e-4;
    const auto depth_cost_at = [&](double s) {
      double xi[6] = {};
      xi[i] = s;
      const NormalEquations at =
          linearize(SE3d::Exp({{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}}) * pose, 9);
      return 4.5 * at.inverse_depth.squares / double(at.inverse_depth.count);
    };
    const double numeric = (depth_cost_at(step) - depth_cost_at(-step)) / (2 * step);
    const double analytic =
        (both.gradient[i] - intensity.gradient[i]) / double(both.inverse_depth.count);
    EXPECT_NEAR(analytic, numeric, 0.05 * std::abs(numeric) + 2e-4) << i;
  }
}

// A board that moves before the wall: the current depth tells which of the wall's pixels it covers.
TEST(CpuBackend, TheCurrentDepthHidesWhatLiesBehindIt) {
  const SE3d motion{{}, {0.25, 0, 0}};
  const View reference = RenderRoomWithBoard({}), current = RenderRoomWithBoard(motion.Inverse());
  const auto backend = MakeCpuBackend();
  const auto full =
      backend->MakeReference(reference.intensity, reference.depth_m, kSmallCamera, {2});
  const auto seen = backend->MakeCurrent(current.intensity, current.depth_m, {2});
  ASSERT_TRUE(seen->has_depth());
  for (const int level : {0, 1}) {
    const auto visible = backend->WithoutHidden({*full, *seen}, level, motion);
    const PhotometricCost before = backend->Cost({*full, *seen}, level, motion);
    const PhotometricCost after = backend->Cost({*visible, *seen}, level, motion);
    EXPECT_LT(after.pixels, before.pixels) << level;
    EXPECT_GT(after.pixels, before.pixels * 2 / 3) << level;
    EXPECT_LT(after.mean(), 0.3 * before.mean()) << level;
  }
}

TEST(CpuBackend, NothingIsComparedBesideDepthEdges) {
  const View board = RenderRoomWithBoard({});
  const auto backend = MakeCpuBackend();
  const auto cost = [&](int reference_margin, int current_margin) {
    const auto reference =
        backend->MakeReference(board.intensity, board.depth_m, kSmallCamera, {1, reference_margin});
    const auto current = backend->MakeCurrent(board.intensity, board.depth_m, {1, current_margin});
    return backend->Cost({*reference, *current}, 0, SE3d{});
  };
  const std::int64_t all = cost(0, 0).pixels;
  const std::int64_t without_edges = cost(2, 0).pixels;
  EXPECT_LT(without_edges, all - 500);
  EXPECT_LT(cost(0, 2).pixels, all - 500);
  // Bilinear interpolation reads one pixel more to the right and below.
  EXPECT_LE(cost(2, 2).pixels, without_edges);
  EXPECT_GT(cost(2, 2).pixels, without_edges - 600);
}

TEST(CpuBackend, TheBitsDoNotDependOnTheNumberOfThreads) {
  const Pair pair = RoomPair();
  SetThreadCount(1);
  const NormalEquations expected = pair.Linearize(kMotion);
  for (const int threads : {2, 3, 0}) {
    SetThreadCount(threads);
    for (int repeat = 0; repeat < 5; ++repeat) EXPECT_EQ(pair.Linearize(kMotion), expected);
  }
}

TEST(CpuBackend, TruePoseCostsLessThanOthers) {
  const Pair pair = RoomPair();
  const double at_truth = pair.Cost(kMotion).mean();
  EXPECT_LT(at_truth, 1e-6);
  EXPECT_GT(pair.Cost(SE3d{}).mean(), 100 * at_truth);
}

TEST(CpuBackend, PixelsWithoutDepthAreLeftOut) {
  Pair full = RoomPair(kSmallCamera, 1);
  View holes = full.reference;
  const float none[] = {0, -1, std::numeric_limits<float>::quiet_NaN(),
                        std::numeric_limits<float>::infinity()};
  for (int i = 0; i < 40 * 60; ++i) holes.depth_m(60 + i % 40, 30 + i / 40) = none[i % 4];
  const Pair pair{holes, full.current, kSmallCamera, 1};
  EXPECT_EQ(full.reference_pyramid->levels()[0].measured_pixels, 160 * 120);
  EXPECT_EQ(pair.reference_pyramid->levels()[0].measured_pixels, 160 * 120 - 40 * 60);
  EXPECT_EQ(pair.Cost(kMotion).pixels, full.Cost(kMotion).pixels - 40 * 60);
  EXPECT_TRUE(std::isfinite(pair.Linearize(kMotion).gradient[0]));
}

TEST(CpuBackend, PixelsOutOfViewOrBehindAreLeftOut) {
  const Pair pair = RoomPair();
  EXPECT_EQ(pair.Cost({Quaterniond::Exp({0, 3.1, 0}), {}}).pixels, 0);
  EXPECT_EQ(pair.Cost({{}, {0, 0, -100}}).pixels, 0);
  const std::int64_t shifted = pair.Cost({Quaterniond::Exp({0, 0.3, 0}), {}}).pixels;
  EXPECT_GT(shifted, 0);
  EXPECT_LT(shifted, 160 * 120 * 3 / 4);
}

TEST(CpuBackend, NonFinitePosesShowNothing) {
  const Pair pair = RoomPair();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pair.Linearize({{}, {nan, 0, 0}}).cost, PhotometricCost{});
  EXPECT_EQ(pair.Linearize({{}, {0, 0, std::numeric_limits<double>::infinity()}}).cost.pixels, 0);
}

// Levels of one pixel and of none.
TEST(CpuBackend, TinyLevelsHaveNoPixels) {
  const Pair pair = RoomPair(CameraOfSize(9, 5), 5);
  EXPECT_GT(pair.Cost(SE3d{}, 0).pixels, 0);
  EXPECT_EQ(pair.reference_pyramid->levels()[4].camera.width, 0);
  for (int level = 2; level < 5; ++level) {
    EXPECT_EQ(pair.Linearize(SE3d{}, level), NormalEquations{}) << level;
  }
}

// Levels that nothing is aligned at are only halved: the others stay as they are.
TEST(CpuBackend, CoarserLevelsAreTheSameWithoutTheFinest) {
  const View reference = RenderRoomWithBoard({}), current = RenderRoomWithBoard(kMotion.Inverse());
  const auto backend = MakeCpuBackend();
  ResidualNorm norm;
  norm.intensity = {0.03, 0.05, 1};
  norm.inverse_depth = {0, 0.01, 25};
  norm.use_depth = true;
  std::vector<NormalEquations> all;
  for (const int finest : {0, 1, 2}) {
    const PyramidOptions options{4, 2, true, finest};
    const auto a =
        backend->MakeReference(reference.intensity, reference.depth_m, kSmallCamera, options);
    const auto b = backend->MakeCurrent(current.intensity, current.depth_m, options);
    const auto visible = backend->WithoutHidden({*a, *b}, 2, {});
    all.push_back(backend->Linearize({*visible, *b}, 2, {}, norm));
    EXPECT_EQ(a->levels()[0].measured_pixels > 0, finest == 0);
    EXPECT_EQ(a->levels()[2].camera.width, kSmallCamera.width / 4);
  }
  EXPECT_GT(all[0].inverse_depth.count, 100);
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
}

TEST(AlignmentOptions, PyramidsBeginWhereSomethingIsAligned) {
  AlignmentOptions options;
  options.max_iterations = {0, 0, 3, 0};
  EXPECT_EQ(options.Pyramids().finest, 2);
  options.max_iterations = {1, 0, 3, 0};
  EXPECT_EQ(options.Pyramids().finest, 0);
  options.max_iterations = {0, 0};
  EXPECT_EQ(options.Pyramids().finest, 1);
}

// 15 tiles of eight rows: eight stripes of two tiles, but for the last.
TEST(CpuBackend, TheScatterIsThatOfEightStripes) {
  const Pair whole = RoomPair();
  const SE3d pose = SE3d::Exp({{0.003, 0, 0}, {0.004, 0, 0}}) * kMotion;
  std::array<double, 21> scatter{};
  for (int first = 0; first < 120; first += 16) {
    View stripe = whole.reference;
    for (int y = 0; y < 120; ++y) {
      if (y < first || y >= first + 16) std::fill_n(stripe.depth_m.row(y), 160, 0.0f);
    }
    const NormalEquations part = Pair{stripe, whole.current, kSmallCamera, 4}.Linearize(pose);
    for (int i = 0, k = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j, ++k) scatter[k] += part.gradient[i] * part.gradient[j];
    }
  }
  const NormalEquations equations = whole.Linearize(pose);
  for (int k = 0; k < 21; ++k) {
    EXPECT_NEAR(equations.scatter[k], scatter[k], 1e-6 * scatter[0]) << k;
  }
}

}  // namespace
}  // namespace silt::tracker
