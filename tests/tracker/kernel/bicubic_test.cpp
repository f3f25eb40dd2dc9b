// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/bicubic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cubic_image_sampler.h"

namespace silt::tracker::kernel {
namespace {

const CubicKernel<double> kCatmullRom(0, 0.5f), kBSpline(1, 0);

Image<float> Pixels(double (*f)(double, double)) {
  Image<float> image(9, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 9; ++x) image(x, y) = float(f(x, y));
  }
  return image;
}

double Wavy(double x, double y) { return 0.5 + 0.3 * std::sin(1.3 * x + 0.4) * std::cos(y); }

TEST(Bicubic, CatmullRomIsExactOnQuadrics) {
  const auto quadric = [](double x, double y) {
    return 0.125 * x * x - 0.25 * x * y + 0.5 * y * y - y;
  };
  const Image<float> image = Pixels(quadric);
  const CubicImageSampler<> sampler{image, kCatmullRom};
  for (const double u : {1.0, 2.3, 5.75, 6.5}) {
    for (const double v : {1.0, 3.6, 4.25}) {
      const Sample<double> sample = sampler.Between(u, v);
      EXPECT_NEAR(sample.value, quadric(u, v), 1e-5);
      EXPECT_NEAR(sample.du, 0.25 * u - 0.25 * v, 1e-5);
      EXPECT_NEAR(sample.dv, v - 0.25 * u - 1, 1e-5);
    }
  }
}

TEST(Bicubic, CatmullRomGoesThroughThePixels) {
  const Image<float> image = Pixels(Wavy);
  const CubicImageSampler<> sampler{image, kCatmullRom};
  EXPECT_NEAR(sampler.Between(3, 2).value, image(3, 2), 1e-12);
  EXPECT_NEAR(sampler.Between(1, 5).value, image(1, 5), 1e-12);
}

// (1, 4, 1)/6 at a pixel.
TEST(Bicubic, TheBSplineIsSmooth) {
  const Image<float> image = Pixels([](double x, double y) { return x == 3 && y == 4 ? 36.0 : 0; });
  const CubicImageSampler<> sampler{image, kBSpline};
  EXPECT_NEAR(sampler.Between(3, 4).value, 16, 1e-5);
  EXPECT_NEAR(sampler.Between(4, 4).value, 4, 1e-5);
  EXPECT_NEAR(sampler.Between(2, 3).value, 1, 1e-5);
  EXPECT_NEAR(sampler.Between(1, 4).value, 0, 1e-5);
}

class BicubicKernels : public testing::TestWithParam<bool> {
 protected:
  const Image<float> image_ = Pixels(Wavy);
  const CubicImageSampler<> sampler_{image_, GetParam() ? kBSpline : kCatmullRom};
};

TEST_P(BicubicKernels, WeightsAddUpToOne) {
  for (const double a : {0.0, 0.2, 0.7, 0.999}) {
    const CubicWeights<double> at(sampler_.kernel, a);
    EXPECT_NEAR(at.weight[0] + at.weight[1] + at.weight[2] + at.weight[3], 1, 1e-6);
    EXPECT_NEAR(at.slope[0] + at.slope[1] + at.slope[2] + at.slope[3], 0, 1e-6);
  }
}

TEST_P(BicubicKernels, DerivativesAreThoseOfTheInterpolant) {
  const double h = 1e-5;
  for (const double u : {2.3, 4.9}) {
    for (const double v : {1.5, 5.02}) {
      const auto f = [&](double x, double y) { return sampler_.Between(x, y).value; };
      EXPECT_NEAR(sampler_.Between(u, v).du, (f(u + h, v) - f(u - h, v)) / (2 * h), 1e-8);
      EXPECT_NEAR(sampler_.Between(u, v).dv, (f(u, v + h) - f(u, v - h)) / (2 * h), 1e-8);
    }
  }
}

// Value and slope go on from one square between pixels to the next.
TEST_P(BicubicKernels, SquaresMeet) {
  const double h = 1e-9;
  const Sample<double> before = sampler_.Between(4 - h, 3.4), after = sampler_.Between(4, 3.4);
  EXPECT_NEAR(before.value, after.value, 1e-6);
  EXPECT_NEAR(before.du, after.du, 1e-6);
  EXPECT_NEAR(before.dv, after.dv, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Both, BicubicKernels, testing::Bool());

}  // namespace
}  // namespace silt::tracker::kernel
