// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/se3.h"
#include "silt/experiments/association.h"
#include "silt/experiments/statistics.h"

namespace silt::experiments {

// The rotation and translation that bring `from` onto `to` with the least sum of squared
// distances (Horn 1987, Umeyama 1991, without scale): to ≈ result·from. Both have the same length
// ≥ 1; where the points leave the rotation undetermined (all on one line, say), one of the best.
SE3d AlignedRigidly(const std::vector<Vec3d>& to, const std::vector<Vec3d>& from);

// The paper's error of one pose (§4.3).
struct PoseError {
  double time_s = 0;
  double position_cm = 0;
  Vec3d orientation_deg;  // log(R_trueᵀ·R_estimated), in the true camera's axes
};

// The estimate is moved so that its first pose equals the true one; nothing else is aligned.
std::vector<PoseError> PaperErrors(const std::vector<PosePair>& pairs);

struct PaperStatistics {
  Statistics position_cm;
  Statistics orientation_deg[3];  // about x, y, z
};
PaperStatistics SummarizePaperErrors(const std::vector<PoseError>& errors);

// Absolute trajectory error: distances in metres after the best rigid alignment.
Statistics AlignedTrajectoryError(const std::vector<PosePair>& pairs);

}  // namespace silt::experiments
