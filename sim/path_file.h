// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/core/se3.h"
#include "silt/sim/camera_path.h"

namespace silt::sim {

// A camera path as a TOML file. World: z up, metres. Camera: x right, y down, z forward.
//
//   [[key]]                       # two or more, in order of time; the camera passes through each
//   time_s   = 0.0                # the first must be 0
//   position = [1.2, 0.4, 1.5]    # of the camera's centre
//   look_at  = [0.0, 2.0, 0.8]    # a point that it sees in the middle of the image; not straight
//                                 # above or below the position
//   roll_deg = 3.0                # optional, about the view direction: > 0 leans the camera's top
//                                 # to its right, so that the picture turns anticlockwise
//
//   [[key]]
//   time_s     = 1.5
//   position   = [1.3, 0.5, 1.5]
//   quaternion = [0, 0, 0, 1]     # instead of look_at and roll_deg: qx qy qz qw of
//                                 # world_from_camera, as in TUM files; its sign does not matter
//
//   [hand_shake]                  # optional; added on top of the spline (see hand_shake.h)
//   position_mm  = 1.5            # root mean square; default 0
//   rotation_deg = 0.2            # root mean square; default 0
//   band_hz      = [0.5, 8.0]     # default
//   seed         = 1              # default 0
//
// Between keys the camera moves on a smooth spline (see spline.h): neither its speed nor its
// look_at point is interpolated linearly. Keys about evenly spaced along the path behave best. The
// turn from one key to the next must stay below 120°, and below some 45° where the camera swings
// back.
//
// Throws silt::Error "file:line: …" for anything else: unknown and missing keys, wrong types, times
// that do not increase, a view direction that look_at leaves undefined.
CameraPath LoadCameraPath(const std::filesystem::path& file);

// The same from text; `name` stands for the file in errors.
CameraPath ParseCameraPath(const std::string& text, const std::string& name);

// world_from_camera of a camera at `position` that sees `target` in the middle of its image and the
// world's z axis pointing up. The view must not be vertical.
SE3d LookAt(const Vec3d& position, const Vec3d& target);

}  // namespace silt::sim
