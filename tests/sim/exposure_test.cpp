// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/exposure.h"

#include <gtest/gtest.h>

#include <limits>

namespace silt::sim {
namespace {

Image<Vec3f> Gray(float value, int width = 10) {
  return Image<Vec3f>(width, 10, {value, value, value});
}

TEST(Exposure, BringsTheGeometricMeanToMiddleGray) {
  EXPECT_NEAR(MeteredExposure({Gray(0.36f)}), 0.5, 1e-5);
  EXPECT_NEAR(MeteredExposure({Gray(0.09f), Gray(0.36f)}), 1, 1e-5);
}

TEST(Exposure, KeepsHighlights) {
  Image<Vec3f> image = Gray(0.01f);
  for (int i = 0; i < 10; ++i) image(i, 0) = {0.5f, 0.5f, 0.5f};  // a tenth of it
  EXPECT_NEAR(MeteredExposure({image}), 2, 1e-5);
  for (int i = 1; i < 10; ++i) image(i, 0) = {0.01f, 0.01f, 0.01f};  // one pixel may turn white
  EXPECT_GT(MeteredExposure({image}), 15);
}

TEST(Exposure, IsFiniteWithoutLight) {
  EXPECT_EQ(MeteredExposure({}), 1);
  EXPECT_EQ(MeteredExposure({Gray(0)}), 1);
  EXPECT_EQ(MeteredExposure({Gray(std::numeric_limits<float>::quiet_NaN())}), 1);
}

}  // namespace
}  // namespace silt::sim
