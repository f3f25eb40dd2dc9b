// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"
#include "silt/experiments/photo_consistency.h"

// The photo-consistency of rendered pairs, see photo_consistency.h.
namespace silt::experiments {

struct ConsistencyPlan {
  int width = 640;
  int pairs = 10;  // evenly spread over the path
  int apart = 10;  // frames from one of a pair to the other
  double fps = 60;

  Json ToJson() const;
};

// How the pictures are made.
struct ConsistencyCase {
  std::string name;
  int samples_per_pixel = 4;
  sim::PixelPattern pattern = sim::PixelPattern::kShared;
  sim::PixelFilter filter = sim::PixelFilter::kBox;
  bool eight_bits = true;  // else the sRGB-encoded float
};
// The patterns, filters and precisions between which a user may choose. First come the two that
// tell whether the truth is right: many samples under the Gaussian filter, which hardly alias; what
// the others differ by more is aliasing.
const std::vector<ConsistencyCase>& ConsistencyCases();

struct ConsistencyResult {
  ConsistencyCase made;
  double median_all = 0, median_gradient = 0;  // |ΔI| in levels
  std::size_t pixels_all = 0, pixels_gradient = 0, hidden = 0;
};
ConsistencyResult MeasureConsistency(const World& world, const ConsistencyPlan& plan,
                                     const ConsistencyCase& made);

struct DepthConsistency {
  double median_m = 0, percentile_999_m = 0, maximum_m = 0;
  std::size_t pixels = 0;  // that show one triangle in both frames
  std::size_t beyond = 0;  // of these: that differ by more than 1e-5 m
  std::size_t hidden = 0;  // whose triangle another one hides

  Json ToJson() const;
};
DepthConsistency MeasureDepthConsistency(const World& world, const ConsistencyPlan& plan);

Json ToJson(const std::vector<ConsistencyResult>& results);
std::string FormatConsistency(const std::vector<ConsistencyResult>& results,
                              const DepthConsistency& depth);

}  // namespace silt::experiments
