// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/pair_alignment.h"
#include "silt/experiments/pose_difference.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/options.h"

// §4.2: how the alignment of two images converges, with and without the pyramid.
namespace silt::experiments {

// The two schemes of Fig. 4.
inline constexpr const char* kFullResolution = "full resolution only";
inline constexpr const char* kPyramid = "four-level pyramid";

// Both keep a log and stop at |dξ| < 1e-6.
tracker::AlignmentOptions PyramidScheme();  // 20/20/5/2 solves
tracker::AlignmentOptions FullResolutionScheme(int max_iterations = 100);

// T = [R_true, 0.6·t_true], where the paper starts from.
SE3d PaperStart(const SE3d& truth);

struct ConvergenceRun {
  std::string scheme;
  PoseDifference start_error, end_error;
  tracker::AlignmentResult result;
};

// Both schemes from the paper's start: first the full resolution only, then the pyramid.
std::vector<ConvergenceRun> RunPaperConvergence(const PairAlignment& pair);

// The paper's Table 1, and the run without a pyramid from the text of §4.2.
struct PaperCosts {
  int level;  // 1 is 640×480
  double initial, final;
};
inline constexpr PaperCosts kPaperTable1[] = {
    {4, 24.27, 2.47}, {3, 13.89, 12.67}, {2, 72.00, 64.20}, {1, 495.44, 477.72}};
inline constexpr PaperCosts kPaperFullResolution = {1, 4386.8, 481.9};
inline constexpr int kPaperFullResolutionIterations = 76;

// The level's initial ÷ final cost ½Σr². Costs depend on the picture's contrast and are not
// comparable themselves.
double CostRatio(const tracker::AlignmentLevel& level);
inline double CostRatio(const PaperCosts& costs) { return costs.initial / costs.final; }

}  // namespace silt::experiments
