// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/backend.h"

namespace silt::experiments {

// Two frames of one camera and the true motion between them. The current one needs no depth.
struct FramePair {
  PinholeCamera camera;
  Frame reference, current;
  SE3d current_from_reference;
};

// Two frames, made ready once and then aligned from as many starts and with as many options as
// wanted. The backend must outlive it.
class PairAlignment {
 public:
  // Without the current depth, for options that differ in no more than the number of levels.
  PairAlignment(const tracker::Backend& backend, const FramePair& pair, int levels);
  // For these options.
  PairAlignment(const tracker::Backend& backend, const FramePair& pair,
                const tracker::AlignmentOptions& options);

  const SE3d& truth() const { return truth_; }
  tracker::ImagePair images() const { return {*reference_, *current_}; }
  tracker::AlignmentResult Align(const SE3d& start, const tracker::AlignmentOptions& options) const;
  // From each of the starts.
  std::vector<tracker::AlignmentResult> AlignAll(const std::vector<SE3d>& starts,
                                                 const tracker::AlignmentOptions& options) const;

 private:
  const tracker::Backend& backend_;
  std::unique_ptr<const tracker::ReferencePyramid> reference_;
  std::unique_ptr<const tracker::CurrentPyramid> current_;
  SE3d truth_;
};

}  // namespace silt::experiments
