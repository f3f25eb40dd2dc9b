// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/pose_difference.h"

#include <nlohmann/json.hpp>

namespace silt::experiments {

PoseDifference Difference(const SE3d& camera_from_world, const SE3d& other_camera_from_world) {
  constexpr double kDegrees = 180 / 3.14159265358979323846;
  const SE3d a = camera_from_world.Inverse(), b = other_camera_from_world.Inverse();
  return {Norm(a.translation - b.translation),
          kDegrees * RotationAngle(a.rotation.Conjugate() * b.rotation)};
}

Json ToJson(const PoseDifference& difference) {
  return {{"distance_m", difference.distance_m}, {"angle_deg", difference.angle_deg}};
}

}  // namespace silt::experiments
