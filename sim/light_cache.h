// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "silt/sim/light_solver.h"

// Solved light on disk: ${XDG_CACHE_HOME:-~/.cache}/silt/light-KEY, named by a fingerprint of all
// that it was computed from, so that an entry is never out of date.
namespace silt::sim {

// The entry for a scene; nothing where the environment names no home for it.
std::optional<std::filesystem::path> LightCacheFile(const Scene& scene,
                                                    const LightingOptions& options);

// The light in a file, if it holds that of `samples` samples and its checksum is right.
std::optional<BakedLight> ReadLight(const std::filesystem::path& file, std::size_t samples);

// Removes older entries beside it. Throws silt::Error where the file cannot be written.
void WriteLight(const std::filesystem::path& file, const BakedLight& light);

}  // namespace silt::sim
