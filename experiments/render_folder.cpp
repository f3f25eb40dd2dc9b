// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/render_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/experiments/folder_ownership.h"
#include "silt/experiments/output.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

// "render/fps is 20 there and 30 here", or nothing where they are the same render.
std::string Difference(const Json& there, const Json& here) {
  for (const char* key : {"config", "commit"}) {
    const Json a = there.value(key, Json()), b = here.value(key, Json());
    if (a == b) continue;
    const Json first = Json::diff(a, b).front();
    const std::string path = first["path"];
    const Json::json_pointer at(path);
    const auto shown = [&](const Json& json) {
      return json.contains(at) ? json[at].dump().substr(0, 60) : std::string("not told");
    };
    const std::string name = path.empty() ? key : path.substr(1);
    return name + " is " + shown(a) + " there and " + shown(b) + " here";
  }
  return "";
}

// Names of the files and folders directly below.
std::vector<std::string> TopNames(const RenderFiles& all) {
  std::set<std::string> names;
  for (const auto* files : {&all.of_frames, &all.of_sequence}) {
    for (const fs::path& file : *files) names.insert(file.begin()->string());
  }
  return {names.begin(), names.end()};
}

// Files that a run that was killed had begun to write (see core/atomic_file.h).
void RemoveParts(const fs::path& folder) {
  std::vector<fs::path> parts;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (IsPartOfFile(entry.path())) parts.push_back(entry.path());
  }
  for (const fs::path& part : parts) fs::remove(part);
}

bool HoldsFrames(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path() != folder / kUnfinished) return true;
  }
  return false;
}

}  // namespace

// Held by a process on the folder itself; the system lets go of it even where the process is
// killed.
class RenderFolder::Lock {
 public:
  explicit Lock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {
    if (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      ::close(file_);
      throw Error(folder.string() + ": another silt is rendering into it");
    }
  }
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

RenderFolder::RenderFolder(const fs::path& place, const Json& manifest, RenderFiles files,
                           bool overwrite)
    : place_(NormalPlace(place)),
      manifest_(std::make_unique<Json>(manifest)),
      files_(std::move(files)) {
  try {
    RequireOwn(place_);
    made_ = fs::create_directories(place_);
    lock_ = std::make_unique<Lock>(place_);
    TakeOver(overwrite);
  } catch (const fs::filesystem_error& error) {
    throw Error(place_.string() + ": cannot be written: " + error.code().message());
  }
  (*manifest_)["entries"] = TopNames(files_);
}

void RenderFolder::TakeOver(bool overwrite) {
  for (const char* name : {kUnfinished, kManifest}) {
    if (!fs::exists(place_ / name)) continue;
    const Json there = ReadJson(place_ / name);
    const std::string difference = Difference(there, *manifest_);
    if (overwrite) {
      RemoveEntries(there);
    } else if (!difference.empty()) {
      throw Error(place_.string() + ": holds another render (" + difference +
                  "); choose another folder, or --overwrite it");
    }
  }
  RemoveParts(place_);
}

void RenderFolder::RemoveEntries(const Json& manifest) const {
  for (const std::string name : manifest["entries"]) fs::remove_all(place_ / name);
  for (const char* name : {kUnfinished, kManifest}) fs::remove(place_ / name);
}

RenderFolder::~RenderFolder() {
  std::error_code ignored;
  try {
    if (!begun_ || HoldsFrames(place_)) return;
    for (const std::string& name : EntryNames(place_)) fs::remove_all(place_ / name, ignored);
  } catch (const std::exception&) {
    return;
  }
  if (made_) fs::remove(place_, ignored);
}

bool RenderFolder::IsWhole() const {
  const auto there = [&](const fs::path& file) { return fs::is_regular_file(place_ / file); };
  return there(kManifest) && !there(kUnfinished) &&
         std::all_of(files_.of_frames.begin(), files_.of_frames.end(), there) &&
         std::all_of(files_.of_sequence.begin(), files_.of_sequence.end(), there);
}

void RenderFolder::Begin() {
  begun_ = true;
  WriteJson(place_ / kUnfinished, *manifest_);
  std::error_code error;
  fs::remove(place_ / kManifest, error);
}

void RenderFolder::Commit() {
  WriteJson(place_ / kManifest, *manifest_);
  std::error_code error;
  fs::remove(place_ / kUnfinished, error);
  if (error) throw Error((place_ / kUnfinished).string() + ": " + error.message());
  begun_ = false;
}

}  // namespace silt::experiments
