// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "silt/core/trajectory.h"
#include "silt/experiments/absolute_error.h"
#include "silt/experiments/json.h"
#include "silt/experiments/relative_error.h"

namespace silt::experiments {

struct EvaluationOptions {
  Convention convention = Convention::kEvo;
  // Windows of the relative pose error.
  double frames = 10, seconds = 1, metres = 1;
};

// All that is said of an estimate against the truth.
struct Evaluation {
  Convention convention = Convention::kEvo;
  int pairs = 0;
  double path_m = 0;      // of the true poses that found a partner
  PaperStatistics paper;  // first poses made equal
  Statistics aligned_m;   // after the best rigid alignment
  // Nothing where the trajectories are shorter than a window.
  std::optional<RelativeError> per_frames, per_seconds, per_metres;
};

// Throws silt::Error where no two poses are of the same time.
Evaluation Evaluate(const Trajectory& truth, const Trajectory& estimate,
                    const EvaluationOptions& options = {});

Json ToJson(const Statistics& statistics);
Json ToJson(const Evaluation& evaluation);

// The same as a table for people.
std::string FormatEvaluation(const Evaluation& evaluation);

}  // namespace silt::experiments
