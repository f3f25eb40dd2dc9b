// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/se3.h"
#include "silt/experiments/json.h"

namespace silt::experiments {

// How far two poses of a camera are apart.
struct PoseDifference {
  double distance_m = 0;  // between the camera's two positions
  double angle_deg = 0;   // of the rotation from one to the other

  bool Within(const PoseDifference& bound) const {
    return distance_m <= bound.distance_m && angle_deg <= bound.angle_deg;
  }
};

// Both are camera_from_world, or current_from_keyframe, so that the camera's position is that of
// their inverses.
PoseDifference Difference(const SE3d& camera_from_world, const SE3d& other_camera_from_world);

Json ToJson(const PoseDifference& difference);

}  // namespace silt::experiments
