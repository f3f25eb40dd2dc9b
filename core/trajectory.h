// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/se3.h"

namespace silt {

struct StampedPose {
  double time_s = 0;
  SE3d world_from_camera;
};

// Poses in order of time.
using Trajectory = std::vector<StampedPose>;

// TUM format: lines `time tx ty tz qx qy qz qw`, camera to world, seconds and metres; `#` starts a
// comment. Throws silt::Error with file and line for a malformed or non-finite line, a quaternion
// whose norm is off 1 by more than 1e-2, and times that do not increase.
Trajectory ReadTumTrajectory(const std::filesystem::path& file);
Trajectory ParseTumTrajectory(std::istream& in, const std::string& name);

// Nine digits after the point, so that a written pose is exact to a nanometre.
std::string FormatTumTrajectory(const Trajectory& trajectory);
void WriteTumTrajectory(const std::filesystem::path& file, const Trajectory& trajectory);

// The pose at a time, on a straight line and an even turn between its neighbours; nothing where
// there is none on either side or where they are more than `widest_gap_s` apart.
std::optional<SE3d> InterpolatedPose(const Trajectory& trajectory, double time_s,
                                     double widest_gap_s);

// Sum of the distances between successive positions, in metres.
double PathLength(const Trajectory& trajectory);

}  // namespace silt
