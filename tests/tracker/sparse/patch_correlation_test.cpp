// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/patch_correlation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "textured_planes.h"

namespace silt::tracker {
namespace {

constexpr int kRadius = 8;

// The texture, seen turned by `angle_rad` and enlarged about the centre (60, 60).
Image<float> Pattern(double angle_rad = 0, double enlarged = 1) {
  Image<float> image(121, 121);
  const double c = std::cos(angle_rad) / enlarged, s = std::sin(angle_rad) / enlarged;
  for (int y = 0; y < 121; ++y) {
    for (int x = 0; x < 121; ++x) {
      const double dx = x - 60, dy = y - 60;
      image(x, y) = float(Texture(0.004 * (c * dx + s * dy), 0.004 * (c * dy - s * dx), 5));
    }
  }
  return image;
}

TEST(PatchCorrelation, IsOneForTheSamePatchWhateverGainAndOffset) {
  const Image<float> a = Pattern();
  Image<float> b = a, negative = a;
  for (float& value : b) value = 0.2f + 0.5f * value;
  for (float& value : negative) value = 1 - value;
  const Patch patch{{55.3, 61.8}};
  EXPECT_NEAR(PatchCorrelation(a, patch, a, patch, kRadius), 1, 1e-12);
  EXPECT_NEAR(PatchCorrelation(a, patch, b, patch, kRadius), 1, 1e-6);
  EXPECT_NEAR(PatchCorrelation(a, patch, negative, patch, kRadius), -1, 1e-6);
}

TEST(PatchCorrelation, IsLowForPatchesOfDifferentPlaces) {
  const Image<float> a = Pattern();
  EXPECT_LT(PatchCorrelation(a, {{30, 30}}, a, {{90, 80}}, kRadius), 0.5);
}

TEST(PatchCorrelation, FollowsTheAngleAndTheSpacing) {
  const double angle = 0.6, enlarged = 1.5;
  const Image<float> a = Pattern(), b = Pattern(angle, enlarged);
  const Patch centre{{60, 60}};
  EXPECT_GT(PatchCorrelation(a, centre, b, {{60, 60}, angle, enlarged}, kRadius), 0.99);
  EXPECT_LT(PatchCorrelation(a, centre, b, centre, kRadius), 0.9);
  EXPECT_LT(PatchCorrelation(a, centre, b, {{60, 60}, -angle, enlarged}, kRadius), 0.9);
}

TEST(PatchCorrelation, IsMinusOneWherePatchLeavesTheImageOrIsFlat) {
  const Image<float> a = Pattern(), flat(121, 121, 0.5f);
  const Patch centre{{60, 60}};
  EXPECT_EQ(PatchCorrelation(a, {{5, 60}}, a, centre, kRadius), -1);
  EXPECT_EQ(PatchCorrelation(a, centre, a, {{60, 116}}, kRadius), -1);
  EXPECT_EQ(PatchCorrelation(a, {{std::nan(""), 60}}, a, centre, kRadius), -1);
  EXPECT_EQ(PatchCorrelation(flat, centre, flat, centre, kRadius), -1);
  EXPECT_EQ(PatchCorrelation(a, centre, Image<float>(), centre, kRadius), -1);
}

}  // namespace
}  // namespace silt::tracker
