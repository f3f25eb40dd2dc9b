// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/spline_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace silt::experiments {
namespace {

template <typename F>
Image<float> Sampled(int width, int height, const F& f) {
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image(x, y) = float(f(x, y));
  }
  return image;
}

TEST(SplineImage, PassesThroughThePixels) {
  const Image<float> image =
      Sampled(9, 7, [](int x, int y) { return (x * 7919 + y * 104729) % 255; });
  const SplineImage spline(image);
  for (int y = 1; y < 5; ++y) {
    for (int x = 1; x < 7; ++x) EXPECT_NEAR(spline.At(x, y), double(image(x, y)), 1e-9);
  }
}

// It reproduces cubics, but for what the reflection at the borders adds.
TEST(SplineImage, ReproducesCubics) {
  const auto f = [](double x, double y) { return 1e-3 * x * x * x - 0.02 * x * y * y + 3 * y; };
  const SplineImage spline(Sampled(80, 80, f));
  EXPECT_NEAR(spline.At(40.3, 39.6), f(40.3, 39.6), 1e-4);
  EXPECT_NEAR(spline.At(38.75, 41.5), f(38.75, 41.5), 1e-4);
}

// A wave of six pixels: cubic convolution (Keys) is wrong by up to 0.02 of its amplitude.
TEST(SplineImage, IsCloserToWavesThanCubicConvolution) {
  const auto wave = [](double x, double) { return std::sin(2 * std::numbers::pi / 6 * x + 0.4); };
  const SplineImage spline(Sampled(96, 8, wave));
  for (double u = 30; u < 60; u += 0.37) EXPECT_NEAR(spline.At(u, 3.5), wave(u, 0), 5e-3) << u;
}

TEST(SplineImage, NeedsTwoPixelsEachWay) {
  EXPECT_THROW(SplineImage{Image<float>(1, 5)}, std::logic_error);
}

}  // namespace
}  // namespace silt::experiments
