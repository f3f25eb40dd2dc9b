// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/se3.h"
#include "silt/tracker/alignment_steps.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/options.h"
#include "silt/tracker/pose_covariance.h"

namespace silt::tracker {

struct AlignmentTimes {
  double residual_ms = 0;  // warps and residuals of trial poses
  double jacobian_ms = 0;  // Jacobians, with the residuals that go with them
  double update_ms = 0;    // solves and pose updates
};

struct AlignmentResult {
  bool ok = false;
  std::string failure;          // one line where not ok
  SE3d current_from_reference;  // finite always; the initial pose where not ok
  PooledVector<AlignmentLevel> levels;
  std::vector<AlignmentStep> log;  // where options.keep_log
  AlignmentTimes times;
  // The residuals' own scales where the norm is robust, else 0: σ of the intensity, and of the
  // inverse depth in 1/m, 0 where it was not compared.
  double intensity_scale = 0, inverse_depth_scale = 0;
  // Of ξ = (ω, v), applied on the left of the pose, which is to say in the current camera's frame.
  // Zeros where not ok.
  Covariance6 covariance{};
  Brightness brightness;  // of the first reference, where options.affine_brightness
  // Of the residuals of judged_residuals.h, where the backend has found them on the way.
  std::optional<NormalEquations::Spread> judged;
  std::optional<SE3d> coarse;  // where it started from, if a CoarseStart has led there
  std::shared_ptr<const AlignmentResult> polished;  // where it was asked for and has been run
  // By the clock of the device that ran it, with all that it was run with; 0: step by step.
  double batch_ms = 0;

  // ½Σr² at the finest level that was run.
  PhotometricCost final_cost() const {
    return levels.empty() ? PhotometricCost{} : levels.back().final_cost;
  }
};

// Alignments of small pictures, one after the other, each from where the one before it has ended.
struct CoarseStart {
  struct Stage {
    AlignmentOptions options;
    OwnedPair pair;
  };
  std::vector<Stage> stages;
  OwnedPair compared;  // by whose finest level the end must be more alike than the beginning
};

// The same pair once more, from where its alignment ends.
struct Polish {
  AlignmentOptions options;
  OwnedPair pair;
};

// Algorithm 1: Levenberg-Marquardt from the coarsest level to the finest, over the pixels of all
// references together. A left update of current_from_anchor is one of every current_from_reference
// too, so that their equations add up. Fails, without an exception, where the images share too few
// pixels or the equations have no finite solution. The result's pose is current_from_anchor. With
// `first` it starts where that leads to from `initial`, if it leads anywhere. A backend that runs
// alignments runs `last` in one go with it; any other leaves that to the caller.
AlignmentResult Align(const Backend& backend, const ReferenceViews& references,
                      const CurrentPyramid& current, const SE3d& initial,
                      const AlignmentOptions& options, const CoarseStart* first = nullptr,
                      const Polish* last = nullptr);
// With one reference, which is the anchor.
AlignmentResult Align(const Backend& backend, const ImagePair& pair, const SE3d& initial,
                      const AlignmentOptions& options);

// Images, which outlive the call, and where to start.
struct AlignmentStart {
  const ReferencePyramid& reference;
  const CurrentPyramid& current;
  SE3d initial;
};

// What Align finds from each of them, as many at once as the backend can run.
std::vector<AlignmentResult> AlignBatch(const Backend& backend,
                                        const std::vector<AlignmentStart>& starts,
                                        const AlignmentOptions& options);

}  // namespace silt::tracker
