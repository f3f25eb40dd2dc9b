// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/sim/response_curve.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{40, 40, 19.5, 14.5, 40, 30};

Image<Vec3f> Grey(float level) { return {kCamera.width, kCamera.height, {level, level, level}}; }

TEST(Sensor, WithoutNoiseDevelopsRadianceTimesExposure) {
  const Sensor sensor({}, kCamera);
  EXPECT_EQ(sensor.Develop(Grey(0.2f), 2.5, {1, 2})(3, 4).g, EncodeSrgb8(0.5f));
  EXPECT_FLOAT_EQ(sensor.Signal(Grey(0.2f), 2.5, {1, 2})(3, 4).x, 0.5f);
}

TEST(Sensor, AddsTheNoiseOfItsModelAfterTheExposure) {
  const Sensor sensor({.noise = HandaNoise{}}, kCamera);
  Image<Vec3f> expected = Grey(0.5f);
  AddNoise(HandaNoise{}, {7, 3}, expected);
  const Image<Vec3f> signal = sensor.Signal(Grey(0.25f), 2, {7, 3});
  for (std::size_t i = 0; i < signal.size(); ++i) {
    EXPECT_EQ(signal.data()[i].x, expected.data()[i].x);
    EXPECT_EQ(signal.data()[i].z, expected.data()[i].z);
  }
  EXPECT_EQ(sensor.Develop(Grey(0.25f), 2, {7, 3}), EncodeSrgb8(expected));
}

TEST(Sensor, RefusesNoiseThatIsNone) {
  EXPECT_THROW(Sensor({.noise = HandaNoise{{-1, 0, 0}, {}}}, kCamera), Error);
  EXPECT_THROW(Sensor({.noise = HandaNoise{{}, {0, 0, 1.0 / 0.0}}}, kCamera), Error);
}

}  // namespace
}  // namespace silt::sim
