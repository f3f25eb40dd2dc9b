// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/bilinear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "silt/tracker/kernel/image_sampler.h"

namespace silt::tracker::kernel {
namespace {

TEST(Bilinear, ExactOnAffineImages) {
  const int width = 7, height = 5;
  std::vector<float> pixels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) pixels.push_back(0.25f + 0.5f * float(x) - 0.125f * float(y));
  }
  const ImageSampler<double> sampler{pixels.data(), width, height};
  for (const double u : {0.0, 0.3, 2.75, 5.999}) {
    for (const double v : {0.0, 1.6, 3.25}) {
      const double x = std::floor(u), y = std::floor(v);
      const Sample<double> sample = Bilinear(sampler(x, y), u - x, v - y);
      EXPECT_NEAR(sample.value, 0.25 + 0.5 * u - 0.125 * v, 1e-14);
      EXPECT_NEAR(sample.du, 0.5, 1e-14);
      EXPECT_NEAR(sample.dv, -0.125, 1e-14);
    }
  }
}

TEST(Bilinear, TakesThePixelsAtTheCorners) {
  const Taps<double> taps{1, 2, 4, 8};
  EXPECT_EQ(Bilinear(taps, 0.0, 0.0).value, 1);
  EXPECT_EQ(Bilinear(taps, 1.0, 0.0).value, 2);
  EXPECT_EQ(Bilinear(taps, 0.0, 1.0).value, 4);
  EXPECT_EQ(Bilinear(taps, 1.0, 1.0).value, 8);
}

// The polynomial is of first degree in each variable, so that differences are exact.
TEST(Bilinear, DerivativesAreThoseOfTheInterpolant) {
  const Taps<double> taps{0.1, 0.7, 0.4, 0.2};
  const double a = 0.3, b = 0.8, h = 0.125;
  const Sample<double> sample = Bilinear(taps, a, b);
  const double du = (Bilinear(taps, a + h, b).value - Bilinear(taps, a - h, b).value) / (2 * h);
  const double dv = (Bilinear(taps, a, b + h).value - Bilinear(taps, a, b - h).value) / (2 * h);
  EXPECT_NEAR(sample.du, du, 1e-14);
  EXPECT_NEAR(sample.dv, dv, 1e-14);
}

}  // namespace
}  // namespace silt::tracker::kernel
