// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/se3.h"

namespace silt::tracker {

// Points in keyframe coordinates and where the current image shows them, one for one.
struct PnpProblem {
  PinholeCamera camera;
  std::vector<Vec3d> points;
  std::vector<Vec2d> pixels;
};

struct PnpOptions {
  double reprojection_px = 2;  // an inlier's largest error
  int max_iterations = 500;    // of RANSAC
  double confidence = 0.999;
  int min_inliers = 12;  // fewer are no pose

  // Throws silt::Error where an option is out of range.
  void Validate() const;
};

struct PnpSolution {
  SE3d current_from_keyframe;
  std::vector<int> inliers;  // indices into the problem, ascending
  double rmse_px = 0;        // of the inliers
};

// Eq. 1: the pose that minimises Σ‖p_k − p̂_k‖² over the inliers that RANSAC finds. Nothing where
// there are too few of them. The same problem always gives the same solution.
std::optional<PnpSolution> SolvePnp(const PnpProblem& problem, const PnpOptions& options = {});

}  // namespace silt::tracker
