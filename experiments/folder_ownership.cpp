// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/folder_ownership.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/experiments/output.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

// The entries that a manifest lists, and itself; none where it is none of silt's.
std::vector<std::string> ListedEntries(const fs::path& folder, const char* manifest_name) {
  if (!fs::is_regular_file(folder / manifest_name)) return {};
  try {
    const Json manifest = ReadJson(folder / manifest_name);
    if (manifest.value("program", "") != "silt") return {};
    auto entries = manifest.value("entries", std::vector<std::string>());
    if (!entries.empty()) entries.push_back(manifest_name);
    return entries;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

std::vector<std::string> EntryNames(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void RequireOwn(const fs::path& place) {
  if (!fs::exists(fs::symlink_status(place))) return;
  if (!fs::is_directory(place)) throw Error(place.string() + ": is there and is no folder");
  std::vector<std::string> ours = ListedEntries(place, kManifest);
  for (std::string& name : ListedEntries(place, kUnfinished)) ours.push_back(std::move(name));
  for (const std::string& name : EntryNames(place)) {
    if (IsPartOfFile(name) || std::find(ours.begin(), ours.end(), name) != ours.end()) continue;
    throw Error(place.string() + ": holds '" + name +
                "', which silt did not write there; choose an empty or a new folder");
  }
}

fs::path NormalPlace(const fs::path& place) {
  return (fs::absolute(place) / "").lexically_normal().parent_path();
}

}  // namespace silt::experiments
