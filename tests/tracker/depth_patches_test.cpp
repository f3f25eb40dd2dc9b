// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT

// Depth whose noise is alike over patches of pixels, as depth cameras have it.
#include <gtest/gtest.h>

#include <cmath>

#include "analytic_room.h"
#include "silt/core/random.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"

namespace silt::tracker {
namespace {

constexpr int kPatch_px = 6;

AlignmentOptions Options(double patch_px) {
  AlignmentOptions options = AccuratePreset().alignment;
  options.max_iterations = {10, 10, 20};
  options.depth_patch_px = patch_px;
  return options;
}

// Of the inverse depth, as triangulation errs; 8-bit noise of the intensity, each pixel's own.
void AddNoise(View* view, std::uint64_t stream) {
  constexpr double per_metre = 3e-3;
  const CounterRandom random(5, stream);
  const int width = view->depth_m.width(), columns = width / kPatch_px + 1;
  for (int y = 0; y < view->depth_m.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      const int patch = y / kPatch_px * columns + x / kPatch_px;
      float& z = view->depth_m(x, y);
      z = float(1 / (1 / double(z) + per_metre * random.Normal(std::uint64_t(patch))));
      view->intensity(x, y) += float(0.008 * random.Normal(std::uint64_t(100000 + y * width + x)));
    }
  }
}

struct Found {
  SE3d pose, truth;
};

Found Align(double patch_px, int seed) {
  const SE3d reference{Quaterniond::Exp({0.1, 0.3, 0}), {0.1, 0, -0.4}};
  const SE3d current =
      reference * SE3d::Exp({{0.01, 0.01 + 0.002 * seed, 0}, {0.02, -0.01, 0.01 * seed}});
  View a = RenderRoom(reference, kSmallCamera, DetailedPattern);
  View b = RenderRoom(current, kSmallCamera, DetailedPattern);
  AddNoise(&a, std::uint64_t(2 * seed));
  AddNoise(&b, std::uint64_t(2 * seed + 1));
  const AlignmentOptions options = Options(patch_px);
  const auto backend = MakeCpuBackend();
  const auto keyframe =
      backend->MakeReference(a.intensity, a.depth_m, kSmallCamera, options.Pyramids());
  const auto frame = backend->MakeCurrent(b.intensity, b.depth_m, options.Pyramids());
  const SE3d truth = current.Inverse() * reference;
  return {tracker::Align(*backend, {*keyframe, *frame}, truth, options).current_from_reference,
          truth};
}

double RootMeanSquare(double patch_px) {
  double squares = 0;
  for (int seed = 0; seed < 8; ++seed) {
    const Found found = Align(patch_px, seed);
    squares += std::pow(Distance(found.pose, found.truth), 2) / 8;
  }
  return std::sqrt(squares);
}

TEST(DepthPatches, WhatIsAlikeOverAPatchCountsOnce) {
  EXPECT_LT(RootMeanSquare(kPatch_px), 0.7 * RootMeanSquare(1));
}

// The weight of depths whose residuals have this scale, in units of 1/σ².
double Weight(double sigma, int level) {
  AlignmentPlan plan;
  plan.levels = level;
  plan.max_iterations[level - 1] = 1;
  plan.measured_pixels[level - 1] = 1000;
  plan.scale_rounds = 4;
  plan.robust = plan.use_depth = true;
  plan.robust_scale = 2;
  plan.depth_patch_px = kPatch_px;
  LevenbergMarquardt optimizer(plan, {});
  NormalEquations equations;
  equations.cost = {1, 1000, 1};
  equations.inverse_depth = {1000 * sigma * sigma, 1000};
  optimizer.Take(plan, equations);
  return optimizer.norm().inverse_depth.weight * sigma * sigma;
}

TEST(DepthPatches, OfNoiseAPatchIsOnePixelAndRoundingKnowsNone) {
  EXPECT_NEAR(Weight(1.9e-4, 1), 1, 1e-12);
  EXPECT_NEAR(Weight(1e-2, 1), 1 / 36.0, 1e-3);
  EXPECT_NEAR(Weight(1e-2, 2), 1 / 9.0, 4e-3);
  EXPECT_NEAR(Weight(1e-1, 4), 1, 1e-12);
}

}  // namespace
}  // namespace silt::tracker
