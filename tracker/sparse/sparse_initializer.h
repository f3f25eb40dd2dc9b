// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/initializer.h"
#include "silt/tracker/sparse/feature.h"
#include "silt/tracker/sparse/keyframe_features.h"
#include "silt/tracker/sparse/match_checks.h"
#include "silt/tracker/sparse/pnp.h"

namespace silt::tracker {

struct SparseOptions {
  FeatureOptions features;
  MatchCheckOptions checks;
  PnpOptions pnp;
  int max_cached_keyframes = 64;

  // Throws silt::Error where an option is out of range.
  void Validate() const;
};

// Right matches of binary descriptors differ in up to a sixth of their bits, however near the best
// one is: the floor under the first check's threshold is raised to that.
SparseOptions OptionsFor(FeatureKind kind);

// How many matches each step of §3.2 left, and what it took.
struct SparseEstimate {
  InitialEstimate estimate;
  int keyframe_features = 0, current_features = 0;
  int matched = 0;         // by FLANN, one to one
  int near = 0;            // of them, after the first check
  int correlated = 0;      // after the second
  int epipolar = 0;        // after the third
  int with_depth = 0;      // of them, with a 3D point: what PnP is given
  double rmse_px = 0;      // reprojection error of the pose's inliers
  double keyframe_ms = 0;  // features, points and trees of the keyframe; ~0 from the cache
  double current_ms = 0;   // features of the current image
  double match_ms = 0, check_ms = 0, pnp_ms = 0;
};

// §3.2: features in both images, matches, the three checks, and the pose from 3D-2D
// correspondences (eq. 1). No estimate where too little is left at some step.
class SparseInitializer : public Initializer {
 public:
  // Throws silt::Error for invalid options.
  explicit SparseInitializer(const SparseOptions& options = {});

  InitialEstimate Estimate(const InitializerInput& input) override;
  // The same with what happened on the way.
  SparseEstimate EstimateInSteps(const InitializerInput& input);

 private:
  SparseOptions options_;
  KeyframeFeatureCache cache_;
};

}  // namespace silt::tracker
