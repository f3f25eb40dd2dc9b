// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/se3.h"

namespace silt::sim {

// Nearer than this to the vertical, in radians, a view direction says too little about a camera's
// heading.
inline constexpr double kLeastTilt_rad = 0.1 * 3.14159265358979323846 / 180;

// world_from_camera of a camera at `position` that sees `target` in the middle of its image and the
// world's z axis pointing up. The view must not be vertical.
SE3d LookAt(const Vec3d& position, const Vec3d& target);

// Whether LookAt is defined for this view direction: not zero, not within kLeastTilt_rad of the
// vertical.
bool HasHeading(const Vec3d& view);

}  // namespace silt::sim
