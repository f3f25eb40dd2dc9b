// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor.h"

#include <gtest/gtest.h>

#include "noise_statistics.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{200, 200, 127.5, 127.5, kWidth, kHeight};

TEST(Sensor, WithoutNoiseDevelopsRadianceTimesExposure) {
  const Sensor sensor({}, kCamera);
  EXPECT_EQ(sensor.Develop(UniformSignal(0.2), 2.5, {1, 2})(3, 4).g, ResponseCurve().Encode8(0.5f));
  EXPECT_FLOAT_EQ(sensor.Signal(UniformSignal(0.2), 2.5, {1, 2})(3, 4).x, 0.5f);
}

TEST(Sensor, PicturesInFloatAreThoseOfEightBitsBeforeRounding) {
  const Sensor sensor({.response = ResponseCurve::Gamma(1.8)}, kCamera);
  const double value = std::pow(0.3, 1 / 1.8);
  EXPECT_NEAR(sensor.DevelopFloat(UniformSignal(0.3), 1, {})(3, 4).y, value, 1e-6);
  EXPECT_EQ(sensor.Develop(UniformSignal(0.3), 1, {})(3, 4).g, std::lround(255 * value));
}

TEST(Sensor, AddsTheNoiseOfItsModelAfterTheExposure) {
  const Sensor handa(SensorOptions::Preset("handa"), kCamera);
  Image<Vec3f> expected = UniformSignal(0.5);
  AddNoise(HandaNoise{}, {7, 3}, expected);
  EXPECT_EQ(ChannelValues(handa.Signal(UniformSignal(0.25), 2, {7, 3}), 2),
            ChannelValues(expected, 2));
  const Sensor emva(SensorOptions::Preset("emva"), kCamera);
  expected = UniformSignal(0.5);
  AddNoise(EmvaNoise{}, {7, 3}, expected);
  EXPECT_EQ(ChannelValues(emva.Signal(UniformSignal(0.25), 2, {7, 3}), 1),
            ChannelValues(expected, 1));
}

TEST(Sensor, LightFallsOffBeforeTheNoise) {
  SensorOptions options;
  options.vignetting.cos4 = true;
  const Sensor clean(options, kCamera);
  const Image<Vec3f> signal = clean.Signal(UniformSignal(0.8), 1, {});
  EXPECT_NEAR(signal(127, 127).x, 0.8, 1e-4);
  // 127.5 pixels off in both directions, at 200 a unit.
  const double cos2 = 1 / (1 + 2 * 0.6375 * 0.6375);
  EXPECT_NEAR(signal(0, 255).x, 0.8 * cos2 * cos2, 1e-6);
  options.noise = HandaNoise{};
  Image<Vec3f> expected = signal;
  AddNoise(HandaNoise{}, {1, 2}, expected);
  const Image<Vec3f> noisy = Sensor(options, kCamera).Signal(UniformSignal(0.8), 1, {1, 2});
  EXPECT_EQ(ChannelValues(noisy, 0), ChannelValues(expected, 0));
}

// The variance of 8-bit codes, in steps²: f′²·σ² of the noise through the response curve, and 1/12
// of the rounding. σ is 0.8 steps or more, for which the rounding's share is 1/12 to 1e-5.
void ExpectVarianceOfCodes(const SensorOptions& options, double level, int channel,
                           double variance) {
  const Image<Rgb8> picture = Sensor(options, kCamera).Develop(UniformSignal(level), 1, {5, 6});
  double sum = 0, squares = 0;
  for (const Rgb8& code : picture) {
    const double value = channel == 0 ? code.r : channel == 1 ? code.g : code.b;
    sum += value;
    squares += value * value;
  }
  const double measured = squares / kCount - (sum / kCount) * (sum / kCount);
  const double slope = 255 * options.response.Slope(level);
  EXPECT_GT(slope * slope * variance, 0.64);
  EXPECT_NEAR(measured / (slope * slope * variance + 1.0 / 12), 1, 0.05)
      << options.NoiseName() << " at " << level;
}

TEST(Sensor, EightBitsHaveTheNoiseThroughTheResponseCurveAndOfTheRounding) {
  const SensorOptions handa = SensorOptions::Preset("handa");
  const double shot[] = {0.0104, 0.0066, 0.0106}, read[] = {0.0045, 0.0038, 0.0050};
  for (int i = 0; i < 10; ++i) {
    const double level = 0.09 + 0.09 * i;
    for (int c = 0; c < 3; ++c) {
      ExpectVarianceOfCodes(handa, level, c, shot[c] * shot[c] * level + read[c] * read[c]);
    }
    SensorOptions emva = SensorOptions::Preset("emva");
    EmvaNoise model;
    model.photons_at_white = 3000;
    emva.noise = model;
    ExpectVarianceOfCodes(emva, level, 1, model.Variance(level));
    emva.response = ResponseCurve::Gamma(2.2);
    if (level > 0.15) ExpectVarianceOfCodes(emva, level, 1, model.Variance(level));
  }
}

TEST(Sensor, PresetsDeclareTheirResponseCurve) {
  EXPECT_EQ(SensorOptions::Preset("none").response.name(), "srgb");
  EXPECT_EQ(SensorOptions::Preset("handa").response.name(), "srgb");
  EXPECT_EQ(SensorOptions::Preset("emva").response.name(), "linear");
  for (const char* name : {"none", "handa", "emva"}) {
    EXPECT_EQ(SensorOptions::Preset(name).NoiseName(), name);
  }
  EXPECT_THROW(SensorOptions::Preset("white"), Error);
}

TEST(Sensor, RefusesNoiseThatIsNone) {
  EXPECT_THROW(Sensor({.noise = HandaNoise{{-1, 0, 0}, {}}}, kCamera), Error);
  EXPECT_THROW(Sensor({.noise = EmvaNoise{.bits = 0}}, kCamera), Error);
}

}  // namespace
}  // namespace silt::sim
