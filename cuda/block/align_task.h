// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/cuda/block/pixel_pass.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/levenberg_marquardt.h"

// What AlignBody works on: plain data that lies in the machine's memory.
namespace silt::cuda {

inline constexpr int kMaxReferences = 4;

// A keyframe, the finest level first.
struct TaskReference {
  const float* intensity[tracker::kMaxPyramidLevels];
  const float* depth_m[tracker::kMaxPyramidLevels];
  PinholeCamera cameras[tracker::kMaxPyramidLevels];
  SE3d anchor_from_reference;
};

// Images to be aligned, and how; any number of alignments start from it.
struct AlignTask {
  tracker::AlignmentPlan plan;
  bool exclude_hidden = false;
  int references = 0;
  TaskReference reference[kMaxReferences];
  const float* intensity[tracker::kMaxPyramidLevels];  // of the current image
  const float* depth_m[tracker::kMaxPyramidLevels];    // null where it has none
  const float* inverse_depth[tracker::kMaxPyramidLevels];
  // At the end, the first reference is compared once more at this level, as it is and with this
  // norm; −1: it is not.
  int judged_level = -1;
  tracker::ResidualNorm judged_norm;
};

// Where there are stages (see AlignmentJob::first), their tasks are those from `first_stage` on,
// and the one behind them has the pictures that are compared, at its finest level.
struct AlignStart {
  int task = 0;
  SE3d initial;
  int first_stage = 0, stages = 0;
  int last_stage = -1;  // the task of AlignmentJob::last; −1: none
};

// What all blocks of a group do between two of its barriers.
struct Round {
  enum class Step {
    kBegin,  // nothing yet
    kEmptyCells,
    kFillCells,
    kSpreadCells,
    kHideBehindCells,
    kHalveVisible,  // to `level`
    kEvaluate,
    kCompareInitial,
    kCompareCoarse,
    kJudge,
    kStop
  };
  Step step = Step::kBegin;
  int task = 0;
  int level = 0;  // 0 is the finest
  Residuals kind = Residuals::kCost;
  bool hide = false;     // takes what the current depth hides from the reference's depth first
  bool visible = false;  // reads the depths of Scratch
  kernel::Warp<float> warp[kMaxReferences];
  kernel::RobustNorm<float> intensity_norm, inverse_depth_norm;
};

// A group's own memory.
struct Scratch {
  // Depths of pixels that are not hidden, those of reference r from r·ScratchSize::visible on: the
  // finest level first, one behind the other.
  float* visible_m;
  float *nearest_m, *spread_m;  // cells of reference r from r·ScratchSize::cells on
  double* unit_sums;            // those of reference r from r·ScratchSize::units·kSums on
  double* tile_sums;
};

// How much of it a group needs.
struct ScratchSize {
  std::size_t visible = 0, cells = 0, units = 0, tiles = 0;  // for one reference
};

}  // namespace silt::cuda
