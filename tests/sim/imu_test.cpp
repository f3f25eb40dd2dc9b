// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/imu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "key_poses.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

CameraPath RestingPath() {
  const SE3d pose{Quaterniond::Exp({0.3, -0.5, 0.2}), {1, 2, 3}};
  return CameraPath(PoseSpline::Through({{0, pose}, {20, pose}}));
}

// A walk of 12 s with turns, held by a hand that shakes.
CameraPath LivelyPath() {
  Trajectory keys;
  for (int i = 0; i <= 12; ++i) {
    const double a = 0.4 * i;
    keys.push_back({double(i),
                    {Quaterniond::Exp({0.2 * std::sin(2 * a), 0.5 * a, 0.1}),
                     {std::cos(a), 2 * std::sin(a), 1.5 + 0.1 * std::sin(3 * a)}}});
  }
  return CameraPath(PoseSpline::Through(keys),
                    HandShake({.position_mm = 2, .rotation_deg = 0.5, .seed = 3}));
}

// Pose and velocity of a sensor, known from its readings alone: q̇ = ½·q·ω, v̇ = R·a + g, ṗ = v.
struct Navigation {
  Quaterniond rotation;
  Vec3d velocity, position;

  Navigation Rate(const ImuSample& reading, const Vec3d& gravity) const {
    const Vec3d& w = reading.angular_velocity;
    const Quaterniond q = rotation * Quaterniond{0, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z};
    return {q, rotation.Normalized() * reading.acceleration + gravity, velocity};
  }
  Navigation Plus(double step_s, const Navigation& rate) const {
    const Quaterniond &q = rotation, &d = rate.rotation;
    return {{q.w + step_s * d.w, q.x + step_s * d.x, q.y + step_s * d.y, q.z + step_s * d.z},
            velocity + step_s * rate.velocity,
            position + step_s * rate.position};
  }
  // Runge and Kutta's fourth-order step over two intervals, whose middle is a reading.
  void Advance(const ImuSample* reading, const Vec3d& gravity) {
    const double step_s = reading[2].time_s - reading[0].time_s;
    const Navigation k1 = Rate(reading[0], gravity);
    const Navigation k2 = Plus(step_s / 2, k1).Rate(reading[1], gravity);
    const Navigation k3 = Plus(step_s / 2, k2).Rate(reading[1], gravity);
    const Navigation k4 = Plus(step_s, k3).Rate(reading[2], gravity);
    *this = Plus(step_s / 6, k1).Plus(step_s / 3, k2).Plus(step_s / 3, k3).Plus(step_s / 6, k4);
    rotation = rotation.Normalized();
  }
};

TEST(Imu, AtRestFeelsGravityUpwards) {
  const CameraPath path = RestingPath();
  const ImuRecording recording = RecordImu(path, {.rate_hz = 100}, 0, 1);
  ASSERT_EQ(recording.samples.size(), 101u);
  for (const ImuSample& sample : recording.samples) {
    EXPECT_LT(Norm(sample.angular_velocity), 1e-12);
    const Vec3d world = path.WorldFromCamera(0).rotation * sample.acceleration;
    EXPECT_LT(Norm(world - Vec3d{0, 0, 9.81}), 1e-12);
  }
}

TEST(Imu, OnATurntableReadsRateAndCentripetalAcceleration) {
  Trajectory keys;
  const double rate = 0.2 * std::numbers::pi;
  for (int i = 0; i <= 80; ++i) {
    const double t = 0.25 * i, a = rate * t;
    keys.push_back({t, {Quaterniond::Exp({0, 0, a}), {std::cos(a), std::sin(a), 0}}});
  }
  const CameraPath path(PoseSpline::Through(keys));
  const ImuSample middle = RecordImu(path, {.rate_hz = 200}, 10, 0.1).samples.front();
  EXPECT_EQ(middle.time_s, 10);
  EXPECT_LT(Norm(middle.angular_velocity - Vec3d{0, 0, rate}), 1e-9);
  // The spline's second derivative is off the circle's by (rate·step)²/12 of itself, and less.
  EXPECT_LT(Norm(middle.acceleration - Vec3d{-rate * rate, 0, 9.81}), 2e-3);
}

// The promise: gravity, rotation and derivatives all fit together.
TEST(Imu, IntegratedTwiceReturnsThePathWithinAMillimetreOver10S) {
  const CameraPath path = LivelyPath();
  const ImuOptions options;
  const double start_s = 1;
  const std::vector<ImuSample> samples = RecordImu(path, options, start_s, 10).samples;
  ASSERT_EQ(samples.size(), 2001u);
  const CameraMotion start = path.Motion(start_s);
  Navigation navigation{start.world_from_camera.rotation, start.velocity,
                        start.world_from_camera.translation};
  double worst_m = 0, worst_rad = 0;
  for (std::size_t i = 2; i < samples.size(); i += 2) {
    navigation.Advance(&samples[i - 2], options.gravity);
    const SE3d truth = path.WorldFromCamera(samples[i].time_s);
    EXPECT_EQ(Norm(samples[i].truth.world_from_imu.translation - truth.translation), 0);
    worst_m = std::max(worst_m, Norm(navigation.position - truth.translation));
    worst_rad =
        std::max(worst_rad, RotationAngle(navigation.rotation.Conjugate() * truth.rotation));
  }
  RecordProperty("worst_mm", std::to_string(1000 * worst_m));
  EXPECT_LT(worst_m, 1e-3);
  EXPECT_LT(worst_rad, 1e-4);
}

// The sample variance of 3·20001 numbers has a relative standard deviation of √(2/60003) = 0.6 %:
// 5 % is 8 of them.
TEST(Imu, WhiteNoiseHasTheDensityAsked) {
  ImuOptions options{.rate_hz = 1000, .seed = 5};
  options.noise = {.gyro_density = 2e-3, .accelerometer_density = 3e-2};
  const CameraPath path = RestingPath();
  const ImuRecording noisy = RecordImu(path, options, 0, 20);
  const ImuRecording ideal = RecordImu(path, {.rate_hz = 1000}, 0, 20);
  double gyro = 0, accelerometer = 0;
  for (std::size_t i = 0; i < noisy.samples.size(); ++i) {
    const Vec3d g = noisy.samples[i].angular_velocity - ideal.samples[i].angular_velocity;
    const Vec3d a = noisy.samples[i].acceleration - ideal.samples[i].acceleration;
    gyro += Dot(g, g);
    accelerometer += Dot(a, a);
    EXPECT_EQ(Norm(noisy.samples[i].truth.gyro_bias), 0);
  }
  const double count = 3.0 * double(noisy.samples.size());
  EXPECT_NEAR(gyro / count / (2e-3 * 2e-3 * 1000), 1, 0.05);
  EXPECT_NEAR(accelerometer / count / (3e-2 * 3e-2 * 1000), 1, 0.05);
}

// Steps of the bias over one second have the variance walk²·1 s, whatever the rate.
TEST(Imu, BiasWalksAsFarAtAnyRate) {
  for (const double rate_hz : {50.0, 400.0}) {
    ImuOptions options{.rate_hz = rate_hz};
    options.noise = {.gyro_walk = 1e-3, .accelerometer_walk = 2e-2};
    double gyro = 0, accelerometer = 0;
    int count = 0;
    for (options.seed = 0; options.seed < 100; ++options.seed) {
      const std::vector<ImuSample> samples = RecordImu(RestingPath(), options, 0, 4).samples;
      const auto second = std::size_t(rate_hz);
      for (std::size_t i = second; i < samples.size(); i += second) {
        const Vec3d g = samples[i].truth.gyro_bias - samples[i - second].truth.gyro_bias;
        const Vec3d a =
            samples[i].truth.accelerometer_bias - samples[i - second].truth.accelerometer_bias;
        gyro += Dot(g, g);
        accelerometer += Dot(a, a);
        count += 3;
      }
    }
    // √(2/1200) = 4 %: 20 % is 5 of them.
    EXPECT_NEAR(gyro / count / 1e-6, 1, 0.2) << rate_hz;
    EXPECT_NEAR(accelerometer / count / 4e-4, 1, 0.2) << rate_hz;
  }
}

TEST(Imu, BiasIsPartOfTheReading) {
  ImuOptions options{.rate_hz = 100};
  options.noise = {.gyro_walk = 1e-2, .accelerometer_walk = 1e-1};
  const ImuSample last = RecordImu(RestingPath(), options, 0, 5).samples.back();
  EXPECT_GT(Norm(last.truth.gyro_bias), 1e-4);
  EXPECT_LT(Norm(last.angular_velocity - last.truth.gyro_bias), 1e-12);
}

TEST(Imu, AStretchReadsAsWithinTheWholeAndAnotherSeedOtherwise) {
  ImuOptions options{.rate_hz = 200, .noise = ImuNoise::Euroc(), .seed = 1};
  const CameraPath path = LivelyPath();
  const std::vector<ImuSample> whole = RecordImu(path, options, 0, 12).samples;
  const std::vector<ImuSample> stretch = RecordImu(path, options, 3, 2).samples;
  ASSERT_EQ(stretch.size(), 401u);
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    EXPECT_EQ(stretch[i].time_s, whole[600 + i].time_s);
    EXPECT_EQ(Norm(stretch[i].acceleration - whole[600 + i].acceleration), 0);
    EXPECT_EQ(Norm(stretch[i].truth.gyro_bias - whole[600 + i].truth.gyro_bias), 0);
  }
  options.seed = 2;
  EXPECT_NE(RecordImu(path, options, 3, 2).samples[7].acceleration.x, stretch[7].acceleration.x);
}

TEST(Imu, RefusesWhatCannotBe) {
  const CameraPath path = RestingPath();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RecordImu(path, {.rate_hz = 0}, 0, 1), Error);
  EXPECT_THROW(RecordImu(path, {.rate_hz = nan}, 0, 1), Error);
  EXPECT_THROW(RecordImu(path, {.noise = {.gyro_density = -1}}, 0, 1), Error);
  EXPECT_THROW(RecordImu(path, {.noise = {.accelerometer_walk = nan}}, 0, 1), Error);
  EXPECT_THROW(RecordImu(path, {}, 19, 2), Error);
  EXPECT_THROW(RecordImu(path, {}, 0, 0), Error);
}

}  // namespace
}  // namespace silt::sim
