// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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

// The kinds of starts that a pair can have: those of InitializerNames() without the ones that ask
// for a motion before it or for the truth.
std::vector<std::string> PairInitializerNames();

// Throws silt::Error for a start that a pair cannot have, and for features beside an initial pose.
void CheckStart(const AlignSetup& setup);

struct AlignedPair {
  tracker::TrackingStatus status = tracker::TrackingStatus::kLost;
  std::string message;                         // one line unless tracked
  double time_s = 0;                           // of the current frame, where its file's name is one
  std::optional<SE3d> current_from_reference;  // nothing where lost
  std::array<double, 36> covariance{};         // of ξ = (ω, v), left, row by row; of a pose alone
  double residual = 0;                         // root mean square of the intensity's, in [0, 1]
  double inverse_depth_residual = 0;           // scale of those, 1/m; 0 where not compared
  double edge_contrast = 0;                    // of the reference, see tracker::ImageContent
  std::string doubt_of_colours;                // one line where that makes colours doubtful
  int iterations = 0;
  double milliseconds = 0;  // from images in memory to the pose, both pyramids included
};

// One pair, read from its files. Throws silt::Error naming a file that cannot be read or whose size
// is not the camera's.
AlignedPair AlignFiles(const PairFiles& files, const AlignSetup& setup);

// The same pose for a camera that looks through a mirror: y axes point the other way.
SE3d Mirrored(const SE3d& pose);

Json ToJson(const AlignedPair& pair);         // null for what a lost pair does not have
std::string Format(const AlignedPair& pair);  // lines for a person

}  // namespace silt::experiments
