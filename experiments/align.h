// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/experiments/json.h"
#include "silt/experiments/pair_list.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {

struct AlignSetup {
  TrackerSetup tracker;
  PinholeCamera camera;   // fy > 0; without a size, that of the first image is taken
  bool mirrored = false;  // poses are told for a camera whose y axis points up, which has fy < 0
  double depth_per_metre = 5000;
  std::optional<SE3d> initial;  // current_from_reference, in the same convention
};

struct AlignedPair {
  SE3d current_from_reference;
  tracker::TrackingStatus status = tracker::TrackingStatus::kLost;
  std::string message;                // one line unless tracked
  std::array<double, 36> covariance;  // of ξ = (ω, v), left, row by row; zeros where lost
  double residual = 0;                // root mean square of the intensity's, in [0, 1]
  double inverse_depth_residual = 0;  // scale of those, 1/m; 0 where not compared
  int iterations = 0;
  bool lost() const { return status == tracker::TrackingStatus::kLost; }
  double milliseconds = 0;  // from images in memory to the pose, both pyramids included
};

// One pair, read from its files. Throws silt::Error naming a file that cannot be read or whose size
// is not the camera's.
AlignedPair AlignFiles(const PairFiles& files, const AlignSetup& setup);

// The same pose for a camera that looks through a mirror: y axes point the other way.
SE3d Mirrored(const SE3d& pose);

Json ToJson(const AlignedPair& pair);
std::string Format(const AlignedPair& pair);  // lines for a person

}  // namespace silt::experiments
