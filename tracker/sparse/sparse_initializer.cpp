// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/sparse_initializer.h"

#include <chrono>
#include <optional>
#include <vector>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

// Milliseconds since the last call.
class LapTimer {
 public:
  double Lap() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Pairs of χ_r and p_c: the matches whose keyframe feature has a depth.
PnpProblem Correspondences(const std::vector<FeatureMatch>& matches,
                           const KeyframeFeatures& keyframe, const std::vector<Feature>& current,
                           const PinholeCamera& camera) {
  PnpProblem problem{camera, {}, {}};
  for (const FeatureMatch& match : matches) {
    const std::optional<Vec3d>& point = keyframe.points[std::size_t(match.keyframe)];
    if (!point) continue;
    problem.points.push_back(*point);
    problem.pixels.push_back(current[std::size_t(match.current)].pixel);
  }
  return problem;
}

}  // namespace

void SparseOptions::Validate() const {
  features.Validate();
  checks.Validate();
  pnp.Validate();
  if (max_cached_keyframes < 1) {
    throw Error("sparse initializer: max_cached_keyframes must be at least 1");
  }
}

SparseOptions OptionsFor(FeatureKind kind) {
  SparseOptions options;
  options.features.kind = kind;
  const bool binary = kind == FeatureKind::kOrb || kind == FeatureKind::kAkaze;
  if (binary) options.checks.distance_floor = 0.8;
  return options;
}

SparseInitializer::SparseInitializer(const SparseOptions& options)
    : options_(options), cache_((options.Validate(), options.max_cached_keyframes)) {}

InitialEstimate SparseInitializer::Estimate(const InitializerInput& input) {
  return EstimateInSteps(input).estimate;
}

SparseEstimate SparseInitializer::EstimateInSteps(const InitializerInput& input) {
  SparseEstimate result;
  LapTimer total, watch;
  const KeyframeFeatures& keyframe =
      cache_.Get(input.keyframe, input.camera, options_.features, input.seed);
  result.keyframe_features = int(keyframe.features.size());
  result.keyframe_ms = watch.Lap();

  const std::vector<Feature> current = DetectFeatures(input.intensity, options_.features);
  result.current_features = int(current.size());
  result.current_ms = watch.Lap();

  std::vector<FeatureMatch> matches = keyframe.index.Match(current);
  result.matched = int(matches.size());
  result.match_ms = watch.Lap();

  matches = KeepNearMatches(matches, options_.checks);
  result.near = int(matches.size());
  matches = KeepCorrelatedMatches(matches, {input.keyframe.intensity, keyframe.features},
                                  {input.intensity, current}, options_.checks);
  result.correlated = int(matches.size());
  matches = KeepEpipolarMatches(matches, keyframe.features, current, options_.checks);
  result.epipolar = int(matches.size());
  result.check_ms = watch.Lap();

  const PnpProblem problem = Correspondences(matches, keyframe, current, input.camera);
  result.with_depth = int(problem.points.size());
  if (const std::optional<PnpSolution> solution = SolvePnp(problem, options_.pnp)) {
    result.estimate.current_from_keyframe = solution->current_from_keyframe;
    result.estimate.inliers = int(solution->inliers.size());
    result.rmse_px = solution->rmse_px;
  }
  result.pnp_ms = watch.Lap();
  result.estimate.matches = result.epipolar;
  result.estimate.milliseconds = total.Lap();
  return result;
}

}  // namespace silt::tracker
