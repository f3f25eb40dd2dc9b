// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/resources.h"

#include <algorithm>
#include <cstdlib>

#include "silt/core/error.h"
#include "silt/experiments/build_info.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

fs::path InstalledShare() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path().parent_path() / "share" / "silt";
}

std::vector<fs::path> SceneFolders() {
  std::vector<fs::path> folders;
  if (const char* chosen = std::getenv("SILT_SCENES"); chosen && *chosen) folders.push_back(chosen);
  folders.push_back(InstalledShare() / "scenes");
  folders.push_back(fs::path(kSourceFolder) / "scenes");
  return folders;
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool LooksLikeAPath(const std::string& name) {
  return name.find('/') != name.npos || fs::path(name).extension() == ".toml";
}

std::vector<fs::path> Entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    entries.push_back(it->path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::vector<std::string> PathNames(const fs::path& scene_file) {
  std::vector<std::string> names;
  for (const fs::path& file : Entries(scene_file.parent_path())) {
    if (file.extension() == ".toml" && file.filename() != "scene.toml") {
      names.push_back(file.stem().string());
    }
  }
  return names;
}

}  // namespace

std::vector<std::string> SceneNames() {
  std::vector<std::string> names;
  for (const fs::path& folder : SceneFolders()) {
    for (const fs::path& entry : Entries(folder)) {
      if (IsFile(entry / "scene.toml")) names.push_back(entry.filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

fs::path SceneFile(const std::string& scene) {
  if (LooksLikeAPath(scene)) {
    if (IsFile(fs::path(scene) / "scene.toml")) return fs::path(scene) / "scene.toml";
    if (IsFile(scene)) return scene;
    throw Error(scene + ": no such scene file, and no folder with a scene.toml");
  }
  for (const fs::path& folder : SceneFolders()) {
    if (IsFile(folder / scene / "scene.toml")) return folder / scene / "scene.toml";
  }
  throw Error("no scene is named '" + scene + "'; there are: " + Listed(SceneNames()) +
              " (a path to a scene.toml works too)");
}

fs::path PathFile(const fs::path& scene_file, const std::string& path) {
  if (LooksLikeAPath(path)) {
    if (IsFile(path)) return path;
    throw Error(path + ": no such trajectory file");
  }
  const std::vector<std::string> names = PathNames(scene_file);
  std::string name = path;
  if (name.empty()) name = names.size() == 1 ? names.front() : "desk";
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw Error("no trajectory is named '" + name + "' beside " + scene_file.string() +
                "; there are: " + Listed(names));
  }
  return scene_file.parent_path() / (name + ".toml");
}

fs::path FigureScript(const std::string& name) {
  for (const fs::path& folder :
       {InstalledShare() / "figures", fs::path(kSourceFolder) / "experiments" / "figures"}) {
    if (IsFile(folder / name)) return folder / name;
  }
  throw Error(name + ": this script, which draws figures, is neither installed nor in the sources");
}

}  // namespace silt::experiments
