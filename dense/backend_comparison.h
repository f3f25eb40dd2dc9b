// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/core/raw_sequence.h"
#include "silt/tracker/keyframe_tracker.h"

// One sequence, tracked by two backends.
namespace silt::dense {

struct TrackedSequence {
  std::vector<SE3d> poses;        // world_from_camera
  std::vector<int> keyframe_ids;  // that each was estimated against
  std::vector<bool> new_keyframe;
  int lost = 0;
  int coarse_starts = 0;    // frames for which a coarse alignment found a better start
  double frames_per_s = 0;  // from images in memory to poses, the first frame left out
};

// From the first frame's true pose. Each frame starts from a coarse, dense alignment
// (coarse_initializer.h: the turn alone) from where the motion leads.
TrackedSequence TrackAll(const std::vector<RawFrame>& frames,
                         const tracker::TrackerOptions& options,
                         std::shared_ptr<const tracker::Backend> backend);

struct SequenceDifference {
  int same_keyframes = 0;             // frames before keyframe decisions first differ
  double metres = 0, radians = 0;     // at most, over those
  double rmse_a_m = 0, rmse_b_m = 0;  // of the positions against the truth, over all frames

  // The two are as close as two backends are to be: within 1e-5 m as long as they agree on
  // keyframes, and then within 10 % of the first one's error.
  bool Agree(int frames) const;
};

SequenceDifference Compare(const TrackedSequence& a, const TrackedSequence& b,
                           const std::vector<RawFrame>& frames);

}  // namespace silt::dense
