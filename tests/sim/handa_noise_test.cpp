// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/handa_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "noise_statistics.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

Image<Vec3f> NoisyLevel(float level, const NoiseKey& key) {
  Image<Vec3f> signal = UniformSignal(double(level));
  AddNoise(HandaNoise{}, key, signal);
  return signal;
}

double Channel(const Vec3f& v, int c) { return c == 0 ? v.x : c == 1 ? v.y : v.z; }

double Variance(double level, int channel) {
  const double shot[] = {0.0104, 0.0066, 0.0106}, read[] = {0.0045, 0.0038, 0.0050};
  return shot[channel] * shot[channel] * level + read[channel] * read[channel];
}

TEST(HandaNoise, MeanAndVarianceFollowTheModelAtTenLevels) {
  for (int i = 0; i < 10; ++i) {
    const float level = float(i) / 9;
    const Image<Vec3f> noisy = NoisyLevel(level, {11, 5});
    for (int c = 0; c < 3; ++c) {
      ExpectMeanAndVariance(ChannelValues(noisy, c), double(level), Variance(double(level), c));
    }
  }
}

double Correlation(const Image<Vec3f>& a, int channel_a, const Image<Vec3f>& b, int channel_b) {
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    sum += (Channel(a.data()[i], channel_a) - 0.5) * (Channel(b.data()[i], channel_b) - 0.5);
  }
  return sum / kCount / std::sqrt(Variance(0.5, channel_a) * Variance(0.5, channel_b));
}

TEST(HandaNoise, ChannelsFramesAndSeedsAreIndependent) {
  const double bound = kSigmas / std::sqrt(double(kCount));
  const Image<Vec3f> a = NoisyLevel(0.5f, {1, 1});
  for (const NoiseKey& key : {NoiseKey{1, 2}, NoiseKey{2, 1}}) {
    const Image<Vec3f> b = NoisyLevel(0.5f, key);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(Correlation(a, c, b, c), 0, bound);
  }
  EXPECT_NEAR(Correlation(a, 0, a, 1), 0, bound);
  EXPECT_NEAR(Correlation(a, 1, a, 2), 0, bound);
  EXPECT_NEAR(Correlation(a, 0, a, 0), 1, 0.05);
  EXPECT_EQ(a(3, 4).x, NoisyLevel(0.5f, {1, 1})(3, 4).x);
}

TEST(HandaNoise, NeighboursAreIndependent) {
  const Image<Vec3f> noisy = NoisyLevel(0.5f, {3, 0});
  double along_x = 0, along_y = 0;
  for (int y = 0; y + 1 < kHeight; ++y) {
    for (int x = 0; x + 1 < kWidth; ++x) {
      along_x += (noisy(x, y).x - 0.5) * (noisy(x + 1, y).x - 0.5);
      along_y += (noisy(x, y).x - 0.5) * (noisy(x, y + 1).x - 0.5);
    }
  }
  const double bound = kSigmas * std::sqrt(double(kCount)) * Variance(0.5, 0);
  EXPECT_NEAR(along_x, 0, bound);
  EXPECT_NEAR(along_y, 0, bound);
}

TEST(HandaNoise, ASaturatedSensorIsNoNoisierThanAFullOne) {
  Image<Vec3f> bright = NoisyLevel(1, {9, 9}), brighter = NoisyLevel(7, {9, 9});
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(bright.data()[i].y, brighter.data()[i].y);
  EXPECT_LT(NoisyLevel(-3, {9, 9})(0, 0).x, 0.1f);
}

TEST(HandaNoise, DoesNotDependOnTheNumberOfThreads) {
  SetThreadCount(1);
  const Image<Vec3f> one = NoisyLevel(0.3f, {4, 4});
  SetThreadCount(0);
  const Image<Vec3f> all = NoisyLevel(0.3f, {4, 4});
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(one.data()[i].z, all.data()[i].z);
}

TEST(HandaNoise, RefusesDeviationsThatAreNone) {
  for (const HandaNoise& bad : {HandaNoise{{-1, 0, 0}, {}}, HandaNoise{{}, {0, 0, 1.0 / 0.0}},
                                HandaNoise{{}, {0, std::nan(""), 0}}, HandaNoise{{0, 2, 0}, {}}}) {
    EXPECT_THROW(bad.Validate(), Error);
  }
  EXPECT_NO_THROW(HandaNoise{}.Validate());
}

}  // namespace
}  // namespace silt::sim
