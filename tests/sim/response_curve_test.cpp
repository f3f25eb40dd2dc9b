// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/response_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace silt::sim {
namespace {

// IEC 61966-2-1 in double.
double Encoded255(double linear) {
  return 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

TEST(ResponseCurve, RoundsToTheNearestCode) {
  for (int i = 0; i <= 200'000; ++i) {
    const float linear = float(i) / 200'000;
    const double exact = Encoded255(linear);
    EXPECT_NEAR(EncodeSrgb8(linear), exact, 0.5 + 1e-3) << linear;
  }
}

TEST(ResponseCurve, ReachesEveryCodeInOrder) {
  int last = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const int code = EncodeSrgb8(float(i) / 100'000);
    EXPECT_TRUE(code == last || code == last + 1);
    last = code;
  }
  EXPECT_EQ(last, 255);
}

TEST(ResponseCurve, ClipsWhatIsOutsideAndSurvivesWhatIsNoNumber) {
  EXPECT_EQ(EncodeSrgb8(0), 0);
  EXPECT_EQ(EncodeSrgb8(-1), 0);
  EXPECT_EQ(EncodeSrgb8(1), 255);
  EXPECT_EQ(EncodeSrgb8(1e30f), 255);
  EXPECT_EQ(EncodeSrgb8(std::numeric_limits<float>::infinity()), 255);
  EXPECT_EQ(EncodeSrgb8(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(EncodeSrgb8(std::nextafter(1.0f, 0.0f)), 255);
}

TEST(ResponseCurve, EncodesImagesChannelByChannel) {
  Image<Vec3f> linear(3, 2, {0, 0.2159f, 1});
  linear(2, 1) = {1, 0, 0.0331f};
  const Image<Rgb8> encoded = EncodeSrgb8(linear);
  EXPECT_EQ(encoded(0, 0), (Rgb8{0, 128, 255}));
  EXPECT_EQ(encoded(2, 1), (Rgb8{255, 0, 51}));
}

}  // namespace
}  // namespace silt::sim
