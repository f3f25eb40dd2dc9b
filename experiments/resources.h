// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace silt::experiments {

// Scenes are looked for in the folder that the environment variable SILT_SCENES names, in
// share/silt/scenes beside the installed program, and in the source tree that it was built from.

// scene.toml of a scene by its name; a path to such a file or to its folder is taken as it is.
// Throws silt::Error that lists the known scenes.
std::filesystem::path SceneFile(const std::string& scene);

// A camera path by its name among the TOML files beside the scene, or by its path. An empty name
// asks for "desk", or for the only one there is. Throws silt::Error that lists those there are.
std::filesystem::path PathFile(const std::filesystem::path& scene_file, const std::string& path);

std::vector<std::string> SceneNames();

// A script that draws figures, in share/silt/figures or the source tree; throws silt::Error.
std::filesystem::path FigureScript(const std::string& name);

}  // namespace silt::experiments
