// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Whether a folder is silt's to fill or to replace: silt's own folders list their entries in a
// manifest.
namespace silt::experiments {

// A run's manifest; one of a render that has not come to its end; both list "entries".
inline constexpr const char* kManifest = "manifest.json";
inline constexpr const char* kUnfinished = "unfinished.json";

// Sorted names.
std::vector<std::string> EntryNames(const std::filesystem::path& folder);

// Throws silt::Error unless the place is free, an empty folder, or one that holds nothing but the
// entries that a manifest of silt's lists there, and files that a killed process had begun.
void RequireOwn(const std::filesystem::path& place);

// `place` absolute and without a slash at its end.
std::filesystem::path NormalPlace(const std::filesystem::path& place);

}  // namespace silt::experiments
