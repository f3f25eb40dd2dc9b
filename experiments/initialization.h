// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/experiments/pair_alignment.h"
#include "silt/experiments/pose_difference.h"
#include "silt/tracker/initializer.h"
#include "silt/tracker/keyframe.h"
#include "silt/tracker/options.h"

// Where a refinement may start from, and how far from the truth that is (§3.2 against its rivals).
namespace silt::experiments {

// A start counts as good if the refinement from it ends within this of the truth.
inline constexpr PoseDifference kInitialized{0.01, 0.5};

enum class StartMethod {
  kIdentity,  // the keyframe's own pose
  kPrevious,  // the true pose of the frame before: a tracker that has made no error yet
  kSparse,    // the sparse initializer
};
inline constexpr StartMethod kStartMethods[] = {StartMethod::kIdentity, StartMethod::kPrevious,
                                                StartMethod::kSparse};
std::string Name(StartMethod method);

// A frame some frames after a keyframe.
struct InitializationCase {
  const tracker::Keyframe& keyframe;
  const Frame& current;
  PinholeCamera camera;
  SE3d current_from_keyframe;   // true
  SE3d previous_from_keyframe;  // true, of the frame before the current one
  int frame_index = 0;
  std::uint64_t seed = 0;
};

struct StartOutcome {
  StartMethod method = StartMethod::kIdentity;
  bool available = false;     // the method gave a pose
  PoseDifference start, end;  // errors before and after the refinement, where available
  bool success = false;       // end is within kInitialized
  int matches = 0, inliers = 0;
  double milliseconds = 0;  // of the method, without the refinement
};

// The outcomes of all methods, in the order of kStartMethods.
std::vector<StartOutcome> TryStarts(const InitializationCase& each, const tracker::Backend& backend,
                                    tracker::Initializer& initializer,
                                    const tracker::AlignmentOptions& refinement);

// Many outcomes of one method at one gap.
struct StartSummary {
  StartMethod method = StartMethod::kIdentity;
  int cases = 0, available = 0, successes = 0;
  // Medians; errors over the cases where the method gave a pose.
  PoseDifference start, end;
  double inliers = 0, milliseconds = 0;
};
StartSummary Summarize(StartMethod method, const std::vector<StartOutcome>& outcomes);

}  // namespace silt::experiments
