// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_motion.h"

#include <gtest/gtest.h>

#include "key_poses.h"
#include "silt/sim/camera_path.h"

namespace silt::sim {
namespace {

constexpr double kStep_s = 1e-4;

// Central differences of the pose itself, with the shake of a hand on top of the spline; their
// error is O(kStep_s²) times the third derivative of a shake at up to 8 Hz.
TEST(CameraMotion, IsTheDerivativeOfThePose) {
  const CameraPath path(PoseSpline::Through(RandomKeys(6)),
                        HandShake({.position_mm = 2, .rotation_deg = 0.5, .seed = 3}));
  for (double t = 0; t < path.duration_s(); t += 0.137) {
    const CameraMotion motion = path.Motion(t);
    const SE3d pose = path.WorldFromCamera(t);
    const SE3d before = path.WorldFromCamera(t - kStep_s),
               after = path.WorldFromCamera(t + kStep_s);
    EXPECT_LT(PoseDistance(pose, motion.world_from_camera), 1e-14);
    const double per_step = 1 / (2 * kStep_s);
    EXPECT_LT(Norm(per_step * (after.translation - before.translation) - motion.velocity), 1e-5);
    const Vec3d turn = (before.rotation.Conjugate() * after.rotation).Log();
    EXPECT_LT(Norm(per_step * turn - motion.angular_velocity), 1e-5);
  }
}

TEST(CameraMotion, AccelerationsAreTheDerivativesOfVelocities) {
  const CameraPath path(PoseSpline::Through(RandomKeys(6)),
                        HandShake({.position_mm = 2, .rotation_deg = 0.5, .seed = 3}));
  const double per_step = 1 / (2 * kStep_s);
  for (double t = 0.05; t < path.duration_s(); t += 0.137) {
    const CameraMotion motion = path.Motion(t);
    const CameraMotion before = path.Motion(t - kStep_s), after = path.Motion(t + kStep_s);
    EXPECT_LT(Norm(per_step * (after.velocity - before.velocity) - motion.acceleration), 1e-3);
    const Vec3d change = after.angular_velocity - before.angular_velocity;
    EXPECT_LT(Norm(per_step * change - motion.angular_acceleration), 1e-3);
  }
}

// d/dt world_from_camera = world_from_camera·[ξ]ₓ: a short move is the exponential of ξ.
TEST(CameraMotion, BodyVelocityMovesThePoseFromTheRight) {
  const CameraPath path(PoseSpline::Through(RandomKeys(6)));
  const double t = 1.234, dt = 1e-5;
  const SE3d predicted = path.WorldFromCamera(t) * SE3d::Exp(dt * path.BodyVelocity(t));
  EXPECT_LT(PoseDistance(predicted, path.WorldFromCamera(t + dt)), 1e-9);
}

// On a circle the acceleration is v²/r towards its centre, and ω turns with the tangent.
TEST(CameraMotion, OfACircle) {
  const TimeJet t = TimeJet::Time(0.7), r(2.0), rate(3.0), half(0.5);
  const SE3<TimeJet> pose{{cos(half * rate * t), TimeJet(), TimeJet(), sin(half * rate * t)},
                          {r * cos(rate * t), r * sin(rate * t), TimeJet()}};
  const CameraMotion motion = MotionOf(pose);
  EXPECT_LT(Norm(motion.acceleration + 9.0 * motion.world_from_camera.translation), 1e-12);
  EXPECT_NEAR(Norm(motion.velocity), 6, 1e-12);
  EXPECT_LT(Norm(motion.angular_velocity - Vec3d{0, 0, 3}), 1e-12);
  EXPECT_LT(Norm(motion.angular_acceleration), 1e-12);
  EXPECT_LT(Norm(motion.BodyVelocity().v - Vec3d{0, 6, 0}), 1e-12);
}

}  // namespace
}  // namespace silt::sim
