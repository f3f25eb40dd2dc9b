// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/output_folder.h"

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/experiments/folder_ownership.h"
#include "silt/experiments/output.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

fs::path Beside(const fs::path& place, const char* what) {
  return place.parent_path() /
         ("." + place.filename().string() + "." + what + "-" + std::to_string(::getpid()));
}

[[noreturn]] void Fail(const fs::path& place, const std::error_code& error) {
  throw Error(place.string() + ": cannot be written: " + error.message());
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& place) : place_(NormalPlace(place)) {
  try {
    RequireOwn(place_);
  } catch (const fs::filesystem_error& error) {
    Fail(place_, error.code());
  }
  path_ = Beside(place_, "part");
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) Fail(place_, error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(path_, ignored);
}

void OutputFolder::Commit(const Json& manifest) {
  Json whole = manifest;
  std::vector<std::string> entries = EntryNames(path_);
  if (std::find(entries.begin(), entries.end(), kManifest) == entries.end()) {
    entries.push_back(kManifest);
  }
  whole["entries"] = entries;
  WriteJson(path_ / kManifest, whole);
  std::error_code error;
  const fs::path old = Beside(place_, "old");
  if (fs::exists(place_)) {
    fs::rename(place_, old, error);
    if (error) Fail(place_, error);
  }
  fs::rename(path_, place_, error);
  if (error) {
    std::error_code ignored;
    fs::rename(old, place_, ignored);
    Fail(place_, error);
  }
  committed_ = true;
  fs::remove_all(old, error);
}

}  // namespace silt::experiments
