// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/se3.h"
#include "silt/tracker/graph/edge_error.h"
#include "silt/tracker/pose_covariance.h"

namespace silt::tracker {

// What was measured between two poses.
struct PoseEdge {
  int from = 0, to = 0;      // indices of poses
  SE3d to_from_from;         // Z
  Covariance6 covariance{};  // of ξ, the truth being exp(ξ)·Z
};

// e of an edge between poses that stand where they are; nothing where its covariance has no
// inverse.
std::optional<EdgeError> ErrorOf(const PoseEdge& edge, const std::vector<SE3d>& world_from_pose);

struct GraphCost {
  double before = 0, after = 0;  // ½Σρ(|e|²) with Huber's ρ
};

// Moves all poses but the first to where they agree best with the edges: by Huber's norm, which
// draws even what drift has torn far apart together, and from there by Cauchy's, which lets go of
// edges that still contradict the others. Ceres on one thread: the same bits each time. Edges
// without an inverse covariance are left out. Throws silt::Error where an edge names no pose.
GraphCost OptimizePoses(const std::vector<PoseEdge>& edges, std::vector<SE3d>* world_from_pose);

}  // namespace silt::tracker
