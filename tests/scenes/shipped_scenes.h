// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace silt::sim {

// The scenes of the source tree: every folder under scenes/ with a scene.toml.
inline std::vector<std::string> ShippedScenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SILT_SOURCE_DIR "/scenes")) {
    if (std::filesystem::exists(entry.path() / "scene.toml")) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline std::filesystem::path ShippedFile(const std::string& scene, const std::string& file) {
  return std::filesystem::path(SILT_SOURCE_DIR "/scenes") / scene / file;
}

// Where the furniture is not installed, there is nothing to load.
inline bool FurnitureIsInstalled() {
  return std::filesystem::exists("/usr/share/sweethome3d/furniture/Scopia.sh3f");
}

}  // namespace silt::sim
