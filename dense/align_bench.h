// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/dense/work_floor.h"
#include "silt/tracker/backend.h"

// How fast a backend aligns: one pair at a time, and many starts at once.
namespace silt::dense {

// Two frames with depth, and the true motion between them.
struct MovedPair {
  PinholeCamera camera;
  Frame reference, current;
  SE3d current_from_reference;
};

struct AlignFigures {
  int alignments = 0, ok = 0;
  double device_ms = 0;  // for one, by the device's clock; 0 of one that has none
  double wall_ms = 0;    // for one, images prepared before
  Work work;             // of one, on the average

  double PerSecond() const;  // by the device's clock if there is one
};

// 20/20/5/2 solves on four levels, none saved: what the paper's refinement takes at most.
tracker::AlignmentOptions RefinementOptions();

// Each pair in turn, so that no alignment finds its images in a cache because the last one used
// them; medians over `repeats` alignments, after each pair has been aligned once.
AlignFigures MeasureRefinement(const tracker::Backend& backend, const std::vector<MovedPair>& pairs,
                               const tracker::AlignmentOptions& options, int repeats);

// All pairs together, from `starts` poses up to 2 cm and 1° from the truth, one pair after the
// other so that those that run at once share no images as far as there are others; once to warm up,
// and once measured.
AlignFigures MeasureBatch(const tracker::Backend& backend, const std::vector<MovedPair>& pairs,
                          const tracker::AlignmentOptions& options, int starts);

}  // namespace silt::dense
