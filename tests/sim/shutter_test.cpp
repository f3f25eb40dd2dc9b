// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace silt::sim {
namespace {

TEST(Shutter, AnInstantHasOnlyPlaces) {
  const std::vector<ShutterSample> samples = ShutterSamples(4, {0, 16});
  EXPECT_EQ(samples.size(), 4u);
  for (const ShutterSample& sample : samples) EXPECT_EQ(sample.time_s, 0);
}

TEST(Shutter, ASinglePictureIsTakenThroughThePixelCentre) {
  const std::vector<ShutterSample> samples = ShutterSamples(1, {0, 16});
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].offset.x, 0);
  EXPECT_EQ(samples[0].offset.y, 0);
}

TEST(Shutter, AnExposureHasAtLeastTheInstantsAskedFor) {
  EXPECT_EQ(ShutterSamples(4, {0.01, 16}).size(), 16u);
  EXPECT_EQ(ShutterSamples(64, {0.01, 16}).size(), 64u);
}

TEST(Shutter, TheExposureIsCoveredEvenlyAboutItsMiddle) {
  const double exposure_s = 1.0 / 60;
  const std::vector<ShutterSample> samples = ShutterSamples(1, {exposure_s, 16});
  double sum = 0;
  std::set<int> strata;
  for (const ShutterSample& sample : samples) {
    EXPECT_LT(std::abs(sample.time_s), exposure_s / 2);
    EXPECT_LT(std::max(std::abs(sample.offset.x), std::abs(sample.offset.y)), 0.5);
    strata.insert(int((sample.time_s / exposure_s + 0.5) * 16));
    sum += sample.time_s;
  }
  EXPECT_EQ(strata.size(), 16u);
  EXPECT_NEAR(sum, 0, 1e-15);
}

// A place that followed time would sharpen or smear a moving edge by up to a pixel.
TEST(Shutter, PlacesAreCentredInEachHalfOfTheExposure) {
  const std::vector<ShutterSample> samples = ShutterSamples(1, {1, 16});
  for (const bool late : {false, true}) {
    Vec2d mean;
    for (const ShutterSample& sample : samples) {
      if ((sample.time_s > 0) == late) mean = mean + 1.0 / 8 * sample.offset;
    }
    EXPECT_LT(std::max(std::abs(mean.x), std::abs(mean.y)), 0.07);
  }
}

}  // namespace
}  // namespace silt::sim
