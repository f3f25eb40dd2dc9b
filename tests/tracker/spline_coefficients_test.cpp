// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/spline_coefficients.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/cubic_image_sampler.h"

namespace silt::tracker {
namespace {

class SplineCoefficientsOf : public testing::TestWithParam<std::pair<int, int>> {};

// Sizes that do and do not divide by the lines that are solved side by side.
TEST_P(SplineCoefficientsOf, MakeASplineThroughThePixels) {
  const auto [width, height] = GetParam();
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image(x, y) = float(0.5 + 0.4 * std::sin(1.7 * x + y * y));
  }
  const Image<float> coefficients = SplineCoefficients(image);
  const kernel::CubicImageSampler<> spline{coefficients, kernel::CubicKernel<double>(1, 0)};
  for (int y = 1; y + 2 < height; ++y) {
    for (int x = 1; x + 2 < width; ++x) {
      EXPECT_NEAR(spline.Between(x, y).value, image(x, y), 3e-6) << x << " " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SplineCoefficientsOf,
                         testing::Values(std::pair{64, 48}, std::pair{37, 21}, std::pair{4, 5},
                                         std::pair{5, 33}));

// To the borders, beyond which they go on as in a mirror.
TEST(SplineCoefficients, OfOneIntensityAreIt) {
  for (const float c : SplineCoefficients(Image<float>(37, 21, 0.5f))) EXPECT_NEAR(c, 0.5, 1e-6);
}

TEST(SplineCoefficients, OfASingleRowAreItself) {
  Image<float> row(7, 1);
  row(3, 0) = 1;
  EXPECT_EQ(SplineCoefficients(row)(3, 0), 1);
}

}  // namespace
}  // namespace silt::tracker
