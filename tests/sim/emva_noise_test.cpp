// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/emva_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "noise_statistics.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

Image<Vec3f> NoisyLevel(const EmvaNoise& model, double level, const NoiseKey& key) {
  Image<Vec3f> signal = UniformSignal(level);
  AddNoise(model, key, signal);
  return signal;
}

// A dim scene and a hot sensor: every term counts.
EmvaNoise LowLight() {
  EmvaNoise model;
  model.photons_at_white = 1500;
  model.dark_current_e_per_s = 8000;
  model.exposure_s = 0.005;
  model.read_noise_e = 9;
  model.bits = 10;
  model.black_dn = 80;
  return model;
}

// σ_y² = K²·(σ_d0² + μ_d + μ_e) + 1/12, written out, over y_max − black.
double LowLightVariance(double level) {
  const double range_dn = 1023 - 80, electrons = 0.77 * 1500, gain = range_dn / electrons;
  return (gain * gain * (9 * 9 + 8000 * 0.005 + electrons * level) + 1.0 / 12) /
         (range_dn * range_dn);
}

TEST(EmvaNoise, MeanAndVarianceFollowTheModelAtTenLevels) {
  for (int i = 0; i < 10; ++i) {
    const double level = 0.085 * i;
    const Image<Vec3f> noisy = NoisyLevel(LowLight(), level, {21, 4});
    for (int c = 0; c < 3; ++c) {
      ExpectMeanAndVariance(ChannelValues(noisy, c), level, LowLightVariance(level));
    }
    EXPECT_NEAR(LowLight().Variance(level) / LowLightVariance(level), 1, 1e-12);
  }
}

TEST(EmvaNoise, ThePresetFillsTheWellAtWhite) {
  const EmvaNoise preset;
  EXPECT_DOUBLE_EQ(preset.PhotonsAtWhite() * preset.quantum_efficiency, preset.full_well_e);
  EXPECT_DOUBLE_EQ(preset.Gain(), (4095.0 - 64) / 32691);
  for (const double level : {0.0, 0.01, 0.1, 0.5, 0.95}) {
    const double electrons = 32691 * level;
    const double variance =
        (6.83 * 6.83 + electrons) / (32691.0 * 32691.0) + 1.0 / 12 / (4031.0 * 4031.0);
    ExpectMeanAndVariance(ChannelValues(NoisyLevel(preset, level, {3, 1}), 1), level, variance);
  }
}

// Counts of few electrons are whole numbers that follow Poisson's law.
TEST(EmvaNoise, FewElectronsAreCounted) {
  EmvaNoise model;
  model.quantum_efficiency = 1;
  model.photons_at_white = 50;
  model.read_noise_e = 0;
  model.bits = 8;
  model.black_dn = 5;
  model.gain_dn_per_e = 5;
  int none = 0;
  for (const double value : ChannelValues(NoisyLevel(model, 0.04, {5, 5}), 0)) {
    const double electrons = value * 250 / 5;
    EXPECT_NEAR(electrons, std::round(electrons), 1e-5);
    none += electrons < 0.5;
  }
  const double p = std::exp(-2.0);
  EXPECT_NEAR(none, kCount * p, kSigmas * std::sqrt(kCount * p * (1 - p)));
}

TEST(EmvaNoise, ClipsAtTheWellAndAtTheConverter) {
  EmvaNoise model;
  model.photons_at_white = 4 * model.full_well_e;  // four wells at white: full at a quarter
  for (const Vec3f& value : NoisyLevel(model, 0.5, {1, 1})) EXPECT_NEAR(value.x, 1, 0.01);
  EXPECT_NEAR(NoisyLevel(model, 0.125, {1, 1})(0, 0).x, 0.39, 0.05);
  for (const float level : {1e30f, -1e30f, std::nanf("")}) {
    const float value = NoisyLevel(LowLight(), double(level), {1, 1})(3, 3).y;
    EXPECT_GE(value, -0.13f);
    EXPECT_LE(value, 1);
  }
}

TEST(EmvaNoise, FixedPatternsStayAndTemporalNoiseChanges) {
  EmvaNoise model;
  model.prnu = 0.02;
  model.dsnu_e = 40;
  const double level = 0.5, electrons = 32691 * level;
  const auto a = ChannelValues(NoisyLevel(model, level, {8, 1}), 0);
  const auto b = ChannelValues(NoisyLevel(model, level, {8, 2}), 0);
  double covariance = 0;
  for (int i = 0; i < kCount; ++i) covariance += (a[i] - level) * (b[i] - level) / kCount;
  const double pattern = (40.0 * 40.0 + 0.02 * 0.02 * electrons * electrons) / (32691.0 * 32691.0);
  const double total = pattern + model.Variance(level);
  EXPECT_NEAR(covariance, pattern, kSigmas * total * std::sqrt(2.0 / kCount));
  ExpectMeanAndVariance(a, level, total);
  EXPECT_NE(a, ChannelValues(NoisyLevel(model, level, {9, 1}), 0));
}

TEST(EmvaNoise, DoesNotDependOnTheNumberOfThreads) {
  SetThreadCount(1);
  const Image<Vec3f> one = NoisyLevel(LowLight(), 0.3, {4, 4});
  SetThreadCount(0);
  const Image<Vec3f> all = NoisyLevel(LowLight(), 0.3, {4, 4});
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(one.data()[i].z, all.data()[i].z);
}

TEST(EmvaNoise, RefusesACameraThatIsNone) {
  const auto refused = [](double EmvaNoise::*member, double value) {
    EmvaNoise model;
    model.*member = value;
    EXPECT_THROW(model.Validate(), Error) << value;
  };
  refused(&EmvaNoise::quantum_efficiency, 0);
  refused(&EmvaNoise::quantum_efficiency, 1.01);
  refused(&EmvaNoise::full_well_e, 0);
  refused(&EmvaNoise::read_noise_e, -1);
  refused(&EmvaNoise::dark_current_e_per_s, -1);
  refused(&EmvaNoise::exposure_s, std::nan(""));
  refused(&EmvaNoise::photons_at_white, -1);
  refused(&EmvaNoise::gain_dn_per_e, -1);
  refused(&EmvaNoise::black_dn, 4095);
  refused(&EmvaNoise::prnu, 2);
  refused(&EmvaNoise::dsnu_e, -1);
  EmvaNoise model;
  model.bits = 100;
  EXPECT_THROW(model.Validate(), Error);
  EXPECT_NO_THROW(EmvaNoise{}.Validate());
}

}  // namespace
}  // namespace silt::sim
