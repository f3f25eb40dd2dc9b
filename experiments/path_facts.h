// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"
#include "silt/sim/camera_path.h"
#include "silt/sim/path_check.h"

namespace silt::experiments {

// How long, far and fast a path is, and how near it follows what it replays: for `silt path info`.
Json PathFacts(const sim::CameraPath& path, const std::filesystem::path& file);
std::string FormatPathFacts(const Json& facts);

// What a check of a path found: for `silt path check`.
Json ToJson(const sim::PathCheck& check);

// Throws silt::Error where the camera passes through a surface during the stretch: `silt render`
// refuses such paths, unless told otherwise.
void RequireNoCrossing(const World& world, const Stretch& stretch);

}  // namespace silt::experiments
