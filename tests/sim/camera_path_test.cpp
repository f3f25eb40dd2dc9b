// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_path.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "key_poses.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

// Once around a circle of radius 1 m in 10 s, looking along the tangent.
CameraPath Circle() {
  Trajectory keys;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    const Vec3d position{std::cos(angle), std::sin(angle), 1.5};
    keys.push_back({0.25 * i, {Quaterniond::Exp({0, 0, angle}), position}});
  }
  return CameraPath(PoseSpline::Through(keys));
}

// Natural ends straighten the circle there, hence the tolerance of the extremes.
TEST(CameraPath, StatisticsOfACircle) {
  const PathStatistics s = Circle().Statistics();
  const double speed = 0.2 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(s.duration_s, 10);
  EXPECT_NEAR(s.length_m, 2 * std::numbers::pi, 1e-3);
  EXPECT_NEAR(s.mean_speed_m_s, speed, 1e-4);
  EXPECT_NEAR(s.max_speed_m_s, speed, 1e-2);
  EXPECT_NEAR(s.mean_turn_deg_s, 36, 1e-6);
  EXPECT_NEAR(s.max_turn_deg_s, 36, 1e-6);
  EXPECT_NEAR(s.max_acceleration_m_s2, speed * speed, 0.12);
  EXPECT_NEAR(s.mean_acceleration_m_s2, speed * speed, 0.02);
  EXPECT_LT(s.max_turn_acceleration_deg_s2, 1e-6);
  EXPECT_LT(Norm(s.lowest - Vec3d{-1, -1, 1.5}), 1e-3);
  EXPECT_LT(Norm(s.highest - Vec3d{1, 1, 1.5}), 1e-3);
  EXPECT_DOUBLE_EQ(Circle().LengthM(), s.length_m);
}

// A turn about x by φ = a·sin(2πt/T) has φ̈ of at most a·(2π/T)²; the path stands still.
TEST(CameraPath, StatisticsOfASwing) {
  Trajectory keys;
  for (int i = 0; i <= 80; ++i) {
    keys.push_back(
        {0.05 * i, {Quaterniond::Exp({0.2 * std::sin(std::numbers::pi * 0.05 * i), 0, 0}), {}}});
  }
  const PathStatistics s = CameraPath(PoseSpline::Through(keys)).Statistics();
  const double rate = std::numbers::pi;
  EXPECT_NEAR(s.max_turn_acceleration_deg_s2, 0.2 * rate * rate * 180 / rate, 0.5);
  EXPECT_EQ(s.max_acceleration_m_s2, 0);
  EXPECT_EQ(s.length_m, 0);
}

TEST(CameraPath, HandShakeAddsToTheSpline) {
  const PoseSpline spline = PoseSpline::Through(RandomKeys(10));
  const HandShake shake({.position_mm = 3, .rotation_deg = 1, .seed = 1});
  const CameraPath shaken(spline, shake);
  double sum = 0;
  const int n = 500;
  for (int i = 0; i < n; ++i) {
    const double t = spline.end_s() * i / n;
    const SE3d expected{spline.At(t).rotation * Quaterniond::Exp(shake.Rotation(t)),
                        spline.At(t).translation + shake.Displacement(t)};
    EXPECT_LT(PoseDistance(shaken.WorldFromCamera(t), expected), 1e-14);
    sum += RotationAngle(spline.At(t).rotation.Conjugate() * shaken.WorldFromCamera(t).rotation);
  }
  EXPECT_GT(sum / n, 0.5 * std::numbers::pi / 180);
}

TEST(CameraPath, SamplesAtMultiplesOfTheFramePeriod) {
  const CameraPath path = Circle();
  const Trajectory all = path.Sample(60);
  ASSERT_EQ(all.size(), 600u);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].time_s, double(k) / 60);
    EXPECT_LT(PoseDistance(all[k].world_from_camera, path.WorldFromCamera(all[k].time_s)), 1e-15);
  }
}

TEST(CameraPath, FramesOfAStretchAreFramesOfTheWhole) {
  const CameraPath path = Circle();
  const Trajectory all = path.Sample(20), stretch = path.Sample(20, 1.5, 2.0);
  ASSERT_EQ(stretch.size(), 40u);
  for (std::size_t k = 0; k < stretch.size(); ++k) {
    EXPECT_EQ(stretch[k].time_s, all[30 + k].time_s);
  }
  EXPECT_EQ(path.Sample(20, 1.51, 0.1).front().time_s, 31.0 / 20);
  EXPECT_EQ(path.Sample(20, 9.9, 0.1).size(), 2u);
}

// 1.1·30 = 33.000000000000004: rounding must neither add nor lose a frame.
TEST(CameraPath, FrameTimesSurviveRounding) {
  EXPECT_EQ(FrameTimes(30, 1.1, 0.1).size(), 3u);
  EXPECT_EQ(FrameTimes(30, 1.1, 0.1).front(), 33.0 / 30);
  EXPECT_EQ(FrameTimes(60, 0, 0.1).size(), 6u);
  EXPECT_EQ(FrameTimes(0.1, 0, 5).size(), 1u);
}

TEST(CameraPath, RefusesStretchesThatCannotBeSampled) {
  const CameraPath path = Circle();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(path.Sample(0, 0, 1), Error);
  EXPECT_THROW(path.Sample(nan, 0, 1), Error);
  EXPECT_THROW(path.Sample(20, -1, 1), Error);
  EXPECT_THROW(path.Sample(20, 0, 0), Error);
  EXPECT_THROW(path.Sample(20, 0, nan), Error);
  EXPECT_THROW(path.Sample(20, 0, 10.1), Error);
  EXPECT_THROW(path.WorldFromCamera(11), Error);
}

}  // namespace
}  // namespace silt::sim
