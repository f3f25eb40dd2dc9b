// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/sim/camera_path.h"
#include "silt/sim/look_at.h"

// clang-format off
// A camera path as a TOML file: one motion, and the unrest of a hand on top of it. World: z up,
// metres. Camera: x right, y down, z forward. Keys without "default" are required.
//
//   [[key]]                       two or more, in order of time; the camera passes through each
//   time_s = 0.0                  the first must be 0
//   position = [1.2, 0.4, 1.5]    of the camera's centre
//   look_at = [0.0, 2.0, 0.8]     a point that it sees in the middle of the image; not straight
//                                 above or below the position
//   roll_deg = 3.0                about the view direction: > 0 leans the camera's top to its
//                                 right, so that the picture turns anticlockwise; default 0
//   quaternion = [0, 0, 0, 1]     instead of look_at and roll_deg: qx qy qz qw of
//                                 world_from_camera, as in TUM files; its sign does not matter
//
//   [replay]                      a recorded trajectory through a smoothing spline (see
//                                 trajectory_smoothing.h), placed in the scene
//   file = "groundtruth.txt"      TUM format; relative to the path file
//   start_s = 0                   of the recording, after its first pose; default 0
//   duration_s = 10               of the recording; default: the rest
//   speed = 1                     2 replays in half the time; default 1
//   scale = 1                     factor of all distances; default 1
//   position = [1.2, 0.4, 1.5]    of the camera at the start; default: as recorded
//   yaw_deg = 0                   turns the motion about the vertical through its start, for
//                                 recordings with z up; default 0. Instead of it look_at (and
//                                 roll_deg) or quaternion as in a key: the camera at the start,
//                                 with which the whole motion turns
//   knot_spacing_s = 0.1          of the spline, on the replay's clock; default 0.1
//   smoothing_s = 0.02            swings with a period of 2π times this are halved; default 0.02
//   max_gap_s = 1                 between successive poses; default 1
//
//   [orbit]                       on a circle about a vertical axis
//   center = [0, 0, 1.4]          of the circle
//   radius = 1.5
//   from_deg = 0                  0: starts at center + (radius, 0, 0); default 0
//   sweep_deg = 360               anticlockwise from above; default 360
//   look_at = [0, 0, 0.8]         or a fixed direction = [x, y, z]; default: the center
//
//   [line]
//   from = [0, 0, 1.5]
//   to = [2, 0, 1.5]
//   look_at = [1, 3, 1]           or direction = [x, y, z]; default: along the line
//
//   [lissajous]                   position = center + amplitude·sin(2π·frequency·t + phase)
//   center = [0, 0, 1.5]
//   amplitude = [0.4, 0.2, 0.1]
//   frequency_hz = [0.2, 0.3, 0.5]
//   phase_deg = [0, 90, 0]        default 0
//   look_at = [0, 3, 1]           or direction = [x, y, z]; one of them is needed
//
//   Also in [orbit], [line], [lissajous]:
//   duration_s = 10
//   ease_s = 1                    the motion takes this long to start from rest, and to come to
//                                 rest; default 0: it is in full motion from start to end
//   roll_deg = 0                  default 0
//
//   [hand_shake]                  optional, on top of any motion (its spectrum: hand_shake.h)
//   position_mm = 1.5             root mean square; default 0
//   rotation_deg = 0.2            root mean square; default 0
//   band_hz = [0.5, 8.0]          default
//   seed = 1                      default 0
//
// Between keys the camera moves on a smooth spline (see spline.h): neither its speed nor its
// look_at point is interpolated linearly. Keys about evenly spaced along the path behave best. The
// turn from one key to the next must stay below 120°, and below some 45° where the camera swings
// back.
// clang-format on
namespace silt::sim {

// Throws silt::Error "file:line: …" for whatever does not follow the format above: unknown and
// missing keys, wrong types, times that do not increase, a view direction that look_at leaves
// undefined, a recording that cannot be read.
CameraPath LoadCameraPath(const std::filesystem::path& file);

// The same from text; `name` stands for the file in errors, and a recording is looked for beside
// it.
CameraPath ParseCameraPath(const std::string& text, const std::string& name);

}  // namespace silt::sim
