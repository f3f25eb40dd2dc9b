// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "silt/experiments/json.h"

namespace silt::experiments {

// A folder of results that appears whole or not at all. It is filled under another name beside its
// place; Commit() moves it there. Unless committed, the destructor removes it.
//
// What is there already is replaced only if silt wrote all of it: an empty folder, or one whose
// manifest.json lists its entries. Everything else is refused.
class OutputFolder {
 public:
  // Throws silt::Error where the place is taken or cannot be written to.
  explicit OutputFolder(const std::filesystem::path& place);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Where to write.
  const std::filesystem::path& path() const { return path_; }

  // Adds manifest.json, with the list of entries, and moves the folder to its place.
  void Commit(const Json& manifest);

 private:
  std::filesystem::path place_, path_;
  bool committed_ = false;
};

}  // namespace silt::experiments
