// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "silt/experiments/pair_alignment.h"

namespace silt::experiments {

struct OdometryRun {
  bool found = false;       // else the pose is the identity
  double milliseconds = 0;  // from images in memory to the pose
  SE3d current_from_reference;
};

// The odometries of OpenCV's rgbd module with its own defaults, from a module that is loaded at run
// time out of lib/silt beside the program's folder.
class OpenCvOdometry {
 public:
  enum class Kind { kRgbd, kRgbdIcp };

  // Nothing where this build or this machine has no such module.
  static std::optional<OpenCvOdometry> Load();

  // Both frames need a depth; silt::Error where one has none.
  OdometryRun Run(const FramePair& pair, Kind kind) const;

 private:
  explicit OpenCvOdometry(void* function) : function_(function) {}
  void* function_;
};

}  // namespace silt::experiments
