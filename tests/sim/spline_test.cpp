// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>

#include "key_poses.h"
#include "silt/core/error.h"
#include "silt/sim/camera_motion.h"

namespace silt::sim {
namespace {

CameraMotion MotionAt(const PoseSpline& spline, double time_s) {
  return MotionOf(spline.At(TimeJet::Time(time_s)));
}

// The natural cubic spline is unique; here from its second derivatives (the textbook system).
TEST(PoseSpline, PositionsAreTheNaturalCubicSpline) {
  const Trajectory keys = RandomKeys(9);
  const int n = int(keys.size());
  const auto t = [&](int i) { return keys[i].time_s; };
  const auto y = [&](int i) { return keys[i].world_from_camera.translation.x; };
  Eigen::MatrixXd a = Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (int i = 1; i + 1 < n; ++i) {
    const double h = t(i) - t(i - 1), k = t(i + 1) - t(i);
    a.row(i).segment(i - 1, 3) << h / 6, (h + k) / 3, k / 6;
    b(i) = (y(i + 1) - y(i)) / k - (y(i) - y(i - 1)) / h;
  }
  const Eigen::VectorXd m = a.partialPivLu().solve(b);
  const PoseSpline spline = PoseSpline::Through(keys);
  for (int i = 0; i + 1 < n; ++i) {
    const double h = t(i + 1) - t(i), u = 0.37 * h, v = h - u;
    const double expected = (m(i) * v * v * v + m(i + 1) * u * u * u) / (6 * h) +
                            (y(i) / h - m(i) * h / 6) * v + (y(i + 1) / h - m(i + 1) * h / 6) * u;
    EXPECT_NEAR(spline.At(t(i) + u).translation.x, expected, 1e-12);
  }
}

TEST(PoseSpline, IsTwiceContinuouslyDifferentiable) {
  const Trajectory keys = RandomKeys(8);
  const PoseSpline spline = PoseSpline::Through(keys);
  for (const StampedPose& key : keys) {
    const double step_s = 1e-9;
    const CameraMotion before = MotionAt(spline, key.time_s - step_s);
    const CameraMotion after = MotionAt(spline, key.time_s + step_s);
    EXPECT_LT(PoseDistance(before.world_from_camera, after.world_from_camera), 1e-7);
    EXPECT_LT(Norm(before.velocity - after.velocity), 1e-7);
    EXPECT_LT(Norm(before.angular_velocity - after.angular_velocity), 1e-7);
    EXPECT_LT(Norm(before.acceleration - after.acceleration), 1e-6);
    EXPECT_LT(Norm(before.angular_acceleration - after.angular_acceleration), 1e-6);
  }
}

TEST(PoseSpline, GoesOnAtConstantVelocityBeyondItsEnds) {
  const PoseSpline spline = PoseSpline::Through(RandomKeys(6));
  for (const double end_s : {0.0, spline.end_s()}) {
    const CameraMotion end = MotionAt(spline, end_s);
    EXPECT_LT(Norm(end.acceleration) + Norm(end.angular_acceleration), 1e-9);
    const double beyond_s = end_s == 0 ? -PoseSpline::kOvertime_s : PoseSpline::kOvertime_s;
    const CameraMotion beyond = MotionAt(spline, end_s + beyond_s);
    EXPECT_LT(Norm(beyond.angular_velocity - end.angular_velocity), 1e-9);
    const Vec3d expected = end.world_from_camera.translation + beyond_s * end.velocity;
    EXPECT_LT(Norm(beyond.world_from_camera.translation - expected), 1e-12);
  }
}

TEST(PoseSpline, VelocityIsTheDerivativeByJets) {
  using Jet = ceres::Jet<double, 1>;
  const PoseSpline spline = PoseSpline::Through(RandomKeys(6));
  for (double t = -0.05; t < spline.end_s(); t += 0.173) {
    const SE3<Jet> pose = spline.At(Jet(t, 0));
    const CameraMotion motion = MotionAt(spline, t);
    const auto& [w, x, y, z] = pose.rotation;
    const Quaterniond q{w.a, x.a, y.a, z.a}, dq{w.v[0], x.v[0], y.v[0], z.v[0]};
    EXPECT_LT(Norm(2.0 * (q.Conjugate() * dq).vec() - motion.angular_velocity), 1e-12);
    const auto& p = pose.translation;
    EXPECT_LT(Norm(Vec3d{p.x.v[0], p.y.v[0], p.z.v[0]} - motion.velocity), 1e-12);
  }
}

TEST(PoseSpline, MovesWithItsKeys) {
  const Trajectory keys = RandomKeys(12);
  const SE3d moved_from_world = SE3d::Exp({{1, -2, 0.7}, {5, -3, 2}});
  Trajectory moved_keys = keys;
  for (StampedPose& key : moved_keys) {
    key.world_from_camera = moved_from_world * key.world_from_camera;
  }
  const PoseSpline spline = PoseSpline::Through(keys), moved = PoseSpline::Through(moved_keys);
  for (double t = 0; t < spline.end_s(); t += 0.1) {
    EXPECT_LT(PoseDistance(moved.At(t), moved_from_world * spline.At(t)), 1e-10);
  }
}

TEST(PoseSpline, IgnoresTheSignsOfQuaternions) {
  const Trajectory keys = RandomKeys(8);
  Trajectory flipped = keys;
  for (std::size_t i = 0; i < keys.size(); i += 2) {
    auto& [w, x, y, z] = flipped[i].world_from_camera.rotation;
    flipped[i].world_from_camera.rotation = {-w, -x, -y, -z};
  }
  const PoseSpline a = PoseSpline::Through(keys), b = PoseSpline::Through(flipped);
  for (double t = 0; t < a.end_s(); t += 0.1) EXPECT_LT(PoseDistance(a.At(t), b.At(t)), 1e-10);
}

// What a spline on SE(3) would not do: its screws bend a straight walk when the camera turns.
TEST(PoseSpline, StaysOnAStraightLineWhileTurningEvenly) {
  const Vec3d turn_rad_s{0.3, -0.5, 0.2}, velocity{0.2, 0.1, -0.1};
  Trajectory keys;
  for (const double t : {0.0, 0.4, 1.7, 2.0, 3.1}) {
    keys.push_back({t, {Quaterniond::Exp(t * turn_rad_s), t * velocity}});
  }
  const PoseSpline spline = PoseSpline::Through(keys);
  for (double t = -0.1; t < 3.2; t += 0.07) {
    const SE3d expected{Quaterniond::Exp(t * turn_rad_s), t * velocity};
    EXPECT_LT(PoseDistance(spline.At(t), expected), 1e-11);
  }
}

TEST(PoseSpline, RefusesTimesOutsideOfIt) {
  const PoseSpline spline = PoseSpline::Through(RandomKeys(4));
  EXPECT_NO_THROW(spline.At(-PoseSpline::kOvertime_s));
  EXPECT_NO_THROW(spline.At(spline.end_s() + PoseSpline::kOvertime_s));
  EXPECT_THROW(spline.At(-PoseSpline::kOvertime_s - 1e-6), Error);
  EXPECT_THROW(spline.At(spline.end_s() + PoseSpline::kOvertime_s + 1e-6), Error);
  EXPECT_THROW(spline.At(std::numeric_limits<double>::quiet_NaN()), Error);
}

}  // namespace
}  // namespace silt::sim
