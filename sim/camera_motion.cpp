// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_motion.h"

namespace silt::sim {
namespace {

// The value, first or second derivative of each component.
Vec3d Component(const Vec3<TimeJet>& v, double TimeJet::*part) {
  return {v.x.*part, v.y.*part, v.z.*part};
}
Quaterniond Component(const Quaternion<TimeJet>& q, double TimeJet::*part) {
  return {q.w.*part, q.x.*part, q.y.*part, q.z.*part};
}

}  // namespace

CameraMotion MotionOf(const SE3<TimeJet>& world_from_camera) {
  const Vec3<TimeJet>& p = world_from_camera.translation;
  const Quaternion<TimeJet>& q = world_from_camera.rotation;
  const Quaterniond rotation = Component(q, &TimeJet::value);
  const Quaterniond inverse = rotation.Conjugate();
  return {.world_from_camera = {rotation, Component(p, &TimeJet::value)},
          .velocity = Component(p, &TimeJet::d1),
          .acceleration = Component(p, &TimeJet::d2),
          .angular_velocity = 2.0 * (inverse * Component(q, &TimeJet::d1)).vec(),
          .angular_acceleration = 2.0 * (inverse * Component(q, &TimeJet::d2)).vec()};
}

}  // namespace silt::sim
