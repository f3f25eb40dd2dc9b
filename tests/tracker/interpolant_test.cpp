// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analytic_room.h"
#include "kernel/cubic_image_sampler.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/sums.h"
#include "silt/tracker/spline_coefficients.h"

// The current image interpolated over 4×4 pixels, by the CPU's backend.
namespace silt::tracker {

static void PrintTo(Interpolant interpolant, std::ostream* out) {
  *out << (interpolant == Interpolant::kBSpline ? "b_spline" : "catmull_rom");
}

namespace {

const SE3d kMotion = SE3d::Exp({{0.02, -0.03, 0.05}, {0.05, -0.02, 0.04}});

PinholeCamera CameraOfSize(int width, int height) {
  return {100, 100, 0.5 * (width - 1), 0.5 * (height - 1), width, height};
}

struct Sums {
  NormalEquations linearized;
  PhotometricCost cost;
};

Sums SumsOf(const View& reference, const View& current, const PinholeCamera& camera,
            Interpolant interpolant, SimdLevel level = BestSimdLevel()) {
  const auto backend = MakeCpuBackend(level);
  PyramidOptions options{1};
  options.interpolant = interpolant;
  const auto a = backend->MakeReference(reference.intensity, reference.depth_m, camera, options);
  const auto b = backend->MakeCurrent(current.intensity, {}, options);
  return {backend->Linearize({*a, *b}, 0, kMotion), backend->Cost({*a, *b}, 0, kMotion)};
}

kernel::Sums<double> SumInDouble(const View& reference, const View& current,
                                 const PinholeCamera& camera, Interpolant interpolant) {
  const bool spline = interpolant == Interpolant::kBSpline;
  const Image<float> pixels = spline ? SplineCoefficients(current.intensity) : current.intensity;
  const kernel::CubicImageSampler<> sampler{
      pixels, kernel::CubicKernel<double>(spline ? 1.0f : 0.0f, spline ? 0.0f : 0.5f)};
  const kernel::Warp<double> warp(kMotion, camera);
  kernel::Sums<double> sums;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      sums.Add(kernel::Linearize<double>(
          warp, sampler,
          {double(x), double(y), reference.depth_m(x, y), reference.intensity(x, y)}));
    }
  }
  return sums;
}

class Interpolants : public testing::TestWithParam<Interpolant> {};

TEST_P(Interpolants, AgreeWithDoublePrecision) {
  for (const auto& [width, height] : {std::pair{160, 120}, {161, 119}, {67, 9}, {18, 17}}) {
    const PinholeCamera camera = CameraOfSize(width, height);
    const View reference = RenderRoom({}, camera);
    const View current = RenderRoom(SE3d::Exp({{0.004, 0.003, 0}, {}}) * kMotion.Inverse(), camera);
    const kernel::Sums<double> expected = SumInDouble(reference, current, camera, GetParam());
    const Sums actual = SumsOf(reference, current, camera, GetParam());
    EXPECT_NEAR(double(actual.cost.pixels), expected.cost.count, 2);
    const double tolerance = 5e-3 / std::max(1.0, expected.cost.count) + 1e-4;
    EXPECT_NEAR(actual.cost.sum, 0.5 * expected.cost.squares, tolerance * expected.cost.squares);
    EXPECT_EQ(actual.cost, actual.linearized.cost);
    const int diagonal[6] = {0, 6, 11, 15, 18, 20};
    for (int i = 0; i < 6; ++i) {
      const double h = expected.hessian[diagonal[i]];
      EXPECT_NEAR(actual.linearized.hessian[diagonal[i]], h, tolerance * h) << i;
      EXPECT_NEAR(actual.linearized.gradient[i], expected.gradient[i],
                  tolerance * std::sqrt(h * expected.cost.squares))
          << i;
    }
  }
}

TEST_P(Interpolants, HaveTheSameBitsAtEverySimdLevel) {
  const View reference = RenderRoom({}), current = RenderRoom(kMotion.Inverse());
  const NormalEquations expected = SumsOf(reference, current, kSmallCamera, GetParam()).linearized;
  for (const SimdLevel level : SupportedSimdLevels()) {
    EXPECT_EQ(SumsOf(reference, current, kSmallCamera, GetParam(), level).linearized, expected);
  }
}

TEST_P(Interpolants, ImagesTooSmallHaveNoPixels) {
  const PinholeCamera camera = CameraOfSize(9, 3);
  const View view = RenderRoom({}, camera);
  EXPECT_EQ(SumsOf(view, view, camera, GetParam()).linearized, NormalEquations{});
}

INSTANTIATE_TEST_SUITE_P(Cubic, Interpolants,
                         testing::Values(Interpolant::kCatmullRom, Interpolant::kBSpline));

// The camera moves along a wall of waves by parts of a pixel: how far off, in pixels, is where the
// alignment ends? No noise; what there is comes of interpolation alone.
double SubPixelBias(Interpolant interpolant, double wavelength_px, double shift_px) {
  const PinholeCamera camera = CameraOfSize(160, 120);
  const double k = 2 * 3.14159265 / wavelength_px;
  const auto wall = [&](double dx) {
    View view{Image<float>(160, 120), Image<float>(160, 120)};
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        view.depth_m(x, y) = 1;
        view.intensity(x, y) =
            float(0.5 + 0.2 * std::sin(k * (x - dx) + 0.3 * y) + 0.1 * std::sin(k * y));
      }
    }
    return view;
  };
  const auto backend = MakeCpuBackend();
  AlignmentOptions options;
  options.max_iterations = {50};
  options.min_update_norm = 1e-9;
  options.interpolant = interpolant;
  const View reference = wall(0), current = wall(shift_px);
  const auto a =
      backend->MakeReference(reference.intensity, reference.depth_m, camera, options.Pyramids());
  const auto b = backend->MakeCurrent(current.intensity, {}, options.Pyramids());
  const AlignmentResult result = Align(*backend, {*a, *b}, {}, options);
  EXPECT_TRUE(result.ok) << result.failure;
  const Vec3d centre = result.current_from_reference * Vec3d{0, 0, 1};
  return camera.fx * centre.x / centre.z - shift_px;
}

double LargestBias(Interpolant interpolant, double wavelength_px) {
  double most = 0;
  for (double shift = 0.1; shift < 0.95; shift += 0.1) {
    most = std::max(most, std::abs(SubPixelBias(interpolant, wavelength_px, shift)));
  }
  std::printf("largest bias at %.0f px, interpolant %d: %.2e px\n", wavelength_px, int(interpolant),
              most);
  return most;
}

// Of single waves, Catmull-Rom's cubics are as far off as bilinear interpolation; they take less
// from their height.
TEST(Interpolation, SplinesLeaveLessSubPixelBias) {
  for (const double wavelength_px : {6, 12, 24}) {
    const double bilinear = LargestBias(Interpolant::kBilinear, wavelength_px);
    const double cubic = LargestBias(Interpolant::kCatmullRom, wavelength_px);
    EXPECT_GT(bilinear, 1e-4);
    EXPECT_LT(cubic, 1.3 * bilinear);
    EXPECT_LT(LargestBias(Interpolant::kBSpline, wavelength_px), 0.25 * bilinear);
  }
}

}  // namespace
}  // namespace silt::tracker
