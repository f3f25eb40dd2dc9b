// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "silt/experiments/json.h"

namespace silt::experiments {

// What a render is about to put into a folder, besides its manifest: paths relative to the folder.
struct RenderFiles {
  std::vector<std::filesystem::path> of_frames, of_sequence;
};

// A folder that a render fills in its place, frame after frame, and goes on to fill when it is
// asked again. While it is unfinished it holds unfinished.json, afterwards manifest.json, each with
// the render's configuration; a render of another configuration is refused, and so is a second
// process.
class RenderFolder {
 public:
  // The manifest's "config" and "commit" tell two renders apart. Throws silt::Error where the place
  // cannot be written to, or holds anything else than this very render; with `overwrite` another
  // one is removed.
  RenderFolder(const std::filesystem::path& place, const Json& manifest, RenderFiles files,
               bool overwrite);
  // Leaves what is there, for the next run; takes away what holds no frame.
  ~RenderFolder();
  RenderFolder(const RenderFolder&) = delete;
  RenderFolder& operator=(const RenderFolder&) = delete;

  const std::filesystem::path& path() const { return place_; }
  // Whether an earlier run finished it and nothing has been taken away since.
  bool IsWhole() const;
  // To be called before the first frame is written.
  void Begin();
  void Commit();

 private:
  class Lock;

  void TakeOver(bool overwrite);
  void RemoveEntries(const Json& manifest) const;

  std::filesystem::path place_;
  std::unique_ptr<Json> manifest_;
  RenderFiles files_;
  std::unique_ptr<Lock> lock_;
  bool made_ = false, begun_ = false;
};

}  // namespace silt::experiments
