// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/trajectory.h"

namespace silt::experiments {

// A true and an estimated pose that are taken to be of the same instant.
struct PosePair {
  StampedPose truth, estimate;
};

// Which tool's rules to follow where the field's two tools differ.
enum class Convention { kEvo, kTum };

// evo's rule: each pose of the shorter trajectory (the estimate where both are equally long) takes
// the nearest one in time of the longer, the earlier of two equally near, if at most
// `tolerance_s` away. A pose of the longer one may serve several.
std::vector<PosePair> AssociateLikeEvo(const Trajectory& truth, const Trajectory& estimate,
                                       double tolerance_s = 0.01);

// The rule of TUM's associate.py: of all pairs less than `tolerance_s` apart the closest is taken
// first (the earlier truth, then the earlier estimate among equals), and each pose only once.
std::vector<PosePair> AssociateLikeTum(const Trajectory& truth, const Trajectory& estimate,
                                       double tolerance_s = 0.02);

std::vector<PosePair> Associate(const Trajectory& truth, const Trajectory& estimate,
                                Convention convention);

// Index of the value nearest to `wanted` in an ascending list, the first of equally near ones.
std::size_t NearestIndex(const std::vector<double>& ascending, double wanted);

std::vector<double> Times(const Trajectory& trajectory);

}  // namespace silt::experiments
