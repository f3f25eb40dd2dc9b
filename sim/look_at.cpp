// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/look_at.h"

#include <cmath>

namespace silt::sim {

SE3d LookAt(const Vec3d& position, const Vec3d& target) {
  const Vec3d forward = Normalized(target - position);
  const Vec3d right = Normalized(Cross(forward, {0, 0, 1}));
  const Mat3d camera_from_world{{right, Cross(forward, right), forward}};
  return {QuaternionFromMatrix(Transposed(camera_from_world)), position};
}

bool HasHeading(const Vec3d& view) {
  return Norm(view) > 1e-6 && std::hypot(view.x, view.y) >= std::sin(kLeastTilt_rad) * Norm(view);
}

}  // namespace silt::sim
