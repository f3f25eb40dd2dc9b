// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/experiments/json.h"
#include "silt/sim/scene.h"

namespace silt::experiments {

// What a scene consists of, for `silt scene info`: name, file, size_m, triangles, vertices,
// memory_mb, ambient, exposure, lights, materials, textures, instances (with their boxes).
Json SceneFacts(const sim::Scene& scene, const std::filesystem::path& file);

// The same to read; of the instances the `instance_limit` with most triangles.
std::string FormatSceneFacts(const Json& facts, int instance_limit);

}  // namespace silt::experiments
