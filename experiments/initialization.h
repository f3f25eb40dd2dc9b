// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/experiments/initializer_choice.h"
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
  kIdentity,          // the keyframe's own pose
  kPrevious,          // the true pose of the frame before: a tracker that has made no error yet
  kConstantVelocity,  // where the true motion between the two frames before leads
  kRotation,          // a coarse alignment of the turn alone, from the previous pose
  kSurf,
  kSift,
  kOrb,
  kAkaze,
  kTruth,  // 2 cm and 1° beside the true pose
};
inline constexpr StartMethod kStartMethods[] = {
    StartMethod::kIdentity, StartMethod::kPrevious, StartMethod::kConstantVelocity,
    StartMethod::kRotation, StartMethod::kSurf,     StartMethod::kSift,
    StartMethod::kOrb,      StartMethod::kAkaze,    StartMethod::kTruth};
inline constexpr PoseDifference kBesideTruth{0.02, 1};
// As ParseInitializer takes it.
std::string Name(StartMethod method);

// Those that some methods need; they keep what they have computed of keyframes.
using Initializers = std::map<StartMethod, std::unique_ptr<tracker::Initializer>>;
Initializers MakeInitializers();

// A frame some frames after a keyframe.
struct InitializationCase {
  const tracker::Keyframe& keyframe;
  const Frame& current;
  PinholeCamera camera;
  SE3d current_from_keyframe;   // true
  SE3d previous_from_keyframe;  // true, of the frame before the current one
  SE3d before_from_keyframe;    // and of the frame before that
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
                                    const Initializers& initializers,
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
