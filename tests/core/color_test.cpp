// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/color.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt {
namespace {

TEST(ColorTest, SrgbIsTheStandardsCurve) {
  EXPECT_EQ(LinearFromSrgb(0), 0);
  EXPECT_NEAR(LinearFromSrgb(1), 1, 1e-6);
  EXPECT_NEAR(LinearFromSrgb(0.5f), 0.21404114f, 1e-6);  // IEC 61966-2-1
  EXPECT_NEAR(SrgbFromLinear(0.18f), 0.46135613f, 1e-6);
  EXPECT_NEAR(LinearFromSrgb(0.04f), 0.04f / 12.92f, 1e-9);
}

TEST(ColorTest, SrgbInvertsForEveryByte) {
  for (int byte = 0; byte < 256; ++byte) {
    EXPECT_NEAR(255 * SrgbFromLinear(LinearFromSrgb(float(byte) / 255)), byte, 1e-3);
  }
}

TEST(ColorTest, CurveGrowsOverTheSeamOfItsTwoPieces) {
  for (float x = 0.039f; x < 0.042f; x += 1e-5f) {
    EXPECT_LT(LinearFromSrgb(x), LinearFromSrgb(x + 1e-5f));
  }
}

TEST(ColorTest, GrayIsTheLumaOnZeroToOne) {
  Image<Rgb8> rgb(4, 1);
  rgb(0, 0) = {255, 255, 255};
  rgb(1, 0) = {255, 0, 0};
  rgb(2, 0) = {0, 255, 0};
  rgb(3, 0) = {0, 0, 255};
  const Image<float> gray = GrayFromRgb(rgb);
  EXPECT_NEAR(gray(0, 0), 1.0f, 1e-6);
  EXPECT_NEAR(gray(1, 0), 0.299f, 1e-6);
  EXPECT_NEAR(gray(2, 0), 0.587f, 1e-6);
  EXPECT_NEAR(gray(3, 0), 0.114f, 1e-6);
}

}  // namespace
}  // namespace silt
