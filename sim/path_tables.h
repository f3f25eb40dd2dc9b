// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "silt/sim/path_shapes.h"
#include "silt/sim/spline.h"
#include "silt/sim/toml_table.h"
#include "silt/sim/trajectory_smoothing.h"

// The tables of a path file (its format: path_file.h). All throw silt::Error "file:line: …" for
// what does not follow the format.
namespace silt::sim {

// The [[key]] tables of the file.
PoseSpline ReadKeys(const TomlTable& file);

// The [replay] table. Its file's path is relative to `folder`.
SmoothedTrajectory ReadReplay(const TomlTable& replay, const std::filesystem::path& folder);

PoseSpline ReadOrbit(const TomlTable& orbit);
PoseSpline ReadLine(const TomlTable& line);
PoseSpline ReadLissajous(const TomlTable& lissajous);

// Rotation of world_from_camera at a position: from look_at and roll_deg, or from quaternion.
Quaterniond ReadRotationAt(const TomlTable& table, const Vec3d& position);

}  // namespace silt::sim
