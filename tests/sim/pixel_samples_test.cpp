// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/pixel_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace silt::sim {
namespace {

std::vector<PixelSample> Scrambled(int n, std::uint32_t pixel,
                                   PixelFilter filter = PixelFilter::kBox) {
  const ScrambledSamples samples(n, filter);
  std::vector<PixelSample> all;
  for (int k = 0; k < n; ++k) all.push_back(samples.At(k, ScrambledSamples::KeyOf(1, 2, pixel)));
  return all;
}

// Each of the boxes 2^-a × 2^-b × 2^-(m-a-b) that tile (x, y, time) holds exactly one of 2^m.
void ExpectNet(const std::vector<PixelSample>& samples, int m) {
  for (int a = 0; a <= m; ++a) {
    for (int b = 0; a + b <= m; ++b) {
      std::set<std::array<int, 3>> boxes;
      for (const PixelSample& s : samples) {
        const auto part = [](double value, int power) {
          return int(std::floor((value + 0.5) * (1 << power)));
        };
        boxes.insert({part(s.offset.x, a), part(s.offset.y, b), part(s.time, m - a - b)});
      }
      EXPECT_EQ(boxes.size(), samples.size()) << "a " << a << ", b " << b;
    }
  }
}

TEST(PixelSamples, BothPatternsAreNetsInSpaceAndTime) {
  ExpectNet(SharedSamples(16, PixelFilter::kBox), 4);
  ExpectNet(SharedSamples(64, PixelFilter::kBox), 6);
  for (const std::uint32_t pixel : {0u, 1u, 307199u}) {
    ExpectNet(Scrambled(16, pixel), 4);
    ExpectNet(Scrambled(64, pixel), 6);
  }
}

TEST(PixelSamples, ASingleOneGoesThroughTheCentre) {
  for (const PixelFilter filter : {PixelFilter::kBox, PixelFilter::kGaussian}) {
    const std::vector<PixelSample> samples = SharedSamples(1, filter);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].offset.x, 0);
    EXPECT_EQ(samples[0].offset.y, 0);
    EXPECT_EQ(samples[0].time, 0);
  }
}

TEST(PixelSamples, TheSharedPatternIsCentredInSpaceAndTime) {
  for (const PixelFilter filter : {PixelFilter::kBox, PixelFilter::kGaussian}) {
    for (const int n : {2, 3, 4, 16, 64}) {
      Vec2d place;
      double time = 0;
      for (const PixelSample& s : SharedSamples(n, filter)) {
        place = place + s.offset;
        time += s.time;
      }
      EXPECT_NEAR(place.x, 0, 1e-12);
      EXPECT_NEAR(place.y, 0, 1e-12);
      EXPECT_NEAR(time, 0, 1e-12);
    }
  }
}

// A place that followed time would sharpen or smear a moving edge by up to a pixel.
TEST(PixelSamples, PlacesAreCentredInEachHalfOfTheExposure) {
  for (const bool late : {false, true}) {
    Vec2d mean;
    for (const PixelSample& sample : SharedSamples(16, PixelFilter::kBox)) {
      if ((sample.time > 0) == late) mean = mean + 1.0 / 8 * sample.offset;
    }
    EXPECT_LT(std::max(std::abs(mean.x), std::abs(mean.y)), 0.07);
  }
}

TEST(PixelSamples, ScrambledOnesDifferByPixelFrameAndSeed) {
  const ScrambledSamples samples(4, PixelFilter::kBox);
  const auto x = [&](std::uint64_t seed, std::uint32_t frame, std::uint32_t pixel) {
    return samples.At(0, ScrambledSamples::KeyOf(seed, frame, pixel)).offset.x;
  };
  EXPECT_EQ(x(1, 2, 3), x(1, 2, 3));
  EXPECT_NE(x(1, 2, 3), x(1, 2, 4));
  EXPECT_NE(x(1, 2, 3), x(1, 3, 3));
  EXPECT_NE(x(1, 2, 3), x(2, 2, 3));
}

// The mean of 20,000 uniform offsets has a deviation of 0.29/√20000 = 0.002: five of them.
TEST(PixelSamples, ScrambledOnesCoverThePixelEvenly) {
  const ScrambledSamples samples(4, PixelFilter::kBox);
  const int pixels = 5000;
  double sum_x = 0, sum_y = 0, sum_xy = 0, sum_jitter = 0;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    for (int k = 0; k < 4; ++k) {
      const PixelSample s = samples.At(k, ScrambledSamples::KeyOf(7, 0, pixel));
      sum_x += s.offset.x, sum_y += s.offset.y, sum_xy += s.offset.x * s.offset.y;
      sum_jitter += 4 * (s.time + 0.5) - k;
    }
  }
  EXPECT_NEAR(sum_x / (4 * pixels), 0, 0.01);
  EXPECT_NEAR(sum_y / (4 * pixels), 0, 0.01);
  EXPECT_NEAR(sum_xy / (4 * pixels), 0, 0.003);
  EXPECT_NEAR(sum_jitter / (4 * pixels), 0.5, 0.01);
}

TEST(PixelSamples, QuantilesAreThoseOfACutOffGaussian) {
  EXPECT_NEAR(GaussianQuantile(0.5), 0, 1e-12);
  // Φ(1) = 0.8413, Φ(−3) = 0.00135: (0.8413 − 0.00135)/(1 − 2·0.00135).
  EXPECT_NEAR(GaussianQuantile(0.842273), 0.6, 2e-5);
  EXPECT_NEAR(GaussianQuantile(0.157727), -0.6, 2e-5);
  EXPECT_NEAR(GaussianQuantile(1e-12), -1.8, 1e-6);
  EXPECT_NEAR(GaussianQuantile(1 - 1e-12), 1.8, 1e-6);
}

double Variance(const std::vector<PixelSample>& samples) {
  double sum = 0;
  for (const PixelSample& s : samples) sum += s.offset.x * s.offset.x / double(samples.size());
  return sum;
}

// Of a uniform pixel 1/12, of σ = 0.6 cut off at 3σ 0.9733·0.36.
TEST(PixelSamples, HaveTheVarianceOfTheirFilter) {
  EXPECT_NEAR(Variance(SharedSamples(256, PixelFilter::kBox)), 1.0 / 12, 1e-3);
  EXPECT_NEAR(Variance(SharedSamples(256, PixelFilter::kGaussian)), 0.3504, 5e-3);
  EXPECT_NEAR(Variance(Scrambled(4096, 5, PixelFilter::kGaussian)), 0.3504, 5e-3);
}

}  // namespace
}  // namespace silt::sim
