// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/convergence.h"

namespace silt::experiments {
namespace {

ConvergenceRun Run(const PairAlignment& pair, const std::string& scheme, const SE3d& start,
                   const tracker::AlignmentOptions& options) {
  ConvergenceRun run{scheme, Difference(pair.truth(), start), {}, pair.Align(start, options)};
  run.end_error = Difference(pair.truth(), run.result.current_from_reference);
  return run;
}

}  // namespace

tracker::AlignmentOptions PyramidScheme() {
  tracker::AlignmentOptions options = tracker::PaperPreset().alignment;
  options.min_update_norm = 1e-6;
  options.keep_log = true;
  return options;
}

tracker::AlignmentOptions FullResolutionScheme(int max_iterations) {
  tracker::AlignmentOptions options = PyramidScheme();
  options.max_iterations = {max_iterations};
  return options;
}

SE3d PaperStart(const SE3d& truth) { return {truth.rotation, 0.6 * truth.translation}; }

std::vector<ConvergenceRun> RunPaperConvergence(const PairAlignment& pair) {
  const SE3d start = PaperStart(pair.truth());
  return {Run(pair, kFullResolution, start, FullResolutionScheme()),
          Run(pair, kPyramid, start, PyramidScheme())};
}

double CostRatio(const tracker::AlignmentLevel& level) {
  return level.final_cost.sum > 0 ? level.initial_cost.sum / level.final_cost.sum : 0;
}

}  // namespace silt::experiments
