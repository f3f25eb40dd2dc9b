// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initialization.h"

#include <optional>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/experiments/statistics.h"
#include "silt/experiments/success_rate.h"

namespace silt::experiments {
namespace {

// The pose that a method offers, if any.
std::optional<SE3d> Start(const InitializationCase& each, const Initializers& initializers,
                          StartOutcome* outcome) {
  const auto found = initializers.find(outcome->method);
  if (found != initializers.end()) {
    const Image<float> intensity = GrayFromRgb(each.current.rgb);
    const tracker::InitialEstimate estimate =
        found->second->Estimate({each.keyframe, each.current, intensity, each.camera, each.seed,
                                 each.frame_index, each.previous_from_keyframe});
    outcome->matches = estimate.matches;
    outcome->inliers = estimate.inliers;
    outcome->milliseconds = estimate.milliseconds;
    return estimate.current_from_keyframe;
  }
  if (outcome->method == StartMethod::kTruth) {
    return RandomStart(each.current_from_keyframe, kBesideTruth, each.seed, each.frame_index);
  }
  const SE3d& previous = each.previous_from_keyframe;
  if (outcome->method == StartMethod::kPrevious) return previous;
  if (outcome->method == StartMethod::kConstantVelocity) {
    return previous * each.before_from_keyframe.Inverse() * previous;
  }
  SILT_CHECK(outcome->method == StartMethod::kIdentity);
  return SE3d{};
}

double MedianOrZero(const std::vector<double>& values) {
  return values.empty() ? 0 : Median(values);
}

}  // namespace

std::string Name(StartMethod method) {
  switch (method) {
    case StartMethod::kIdentity:
      return "identity";
    case StartMethod::kPrevious:
      return "previous";
    case StartMethod::kConstantVelocity:
      return "constant-velocity";
    case StartMethod::kRotation:
      return "rotation";
    case StartMethod::kSurf:
      return "surf";
    case StartMethod::kSift:
      return "sift";
    case StartMethod::kOrb:
      return "orb";
    case StartMethod::kAkaze:
      return "akaze";
    case StartMethod::kTruth:
      return "truth:0.02m,1deg";
  }
  return "?";
}

Initializers MakeInitializers() {
  Initializers all;
  for (const StartMethod method : kStartMethods) {
    if (auto initializer = MakeInitializer(ParseInitializer(Name(method)))) {
      all.emplace(method, std::move(initializer));
    }
  }
  return all;
}

std::vector<StartOutcome> TryStarts(const InitializationCase& each, const tracker::Backend& backend,
                                    const Initializers& initializers,
                                    const tracker::AlignmentOptions& refinement) {
  const PairAlignment pair(
      backend, {each.camera, each.keyframe.frame, each.current, each.current_from_keyframe},
      refinement.levels());
  std::vector<StartOutcome> outcomes;
  for (const StartMethod method : kStartMethods) {
    StartOutcome outcome;
    outcome.method = method;
    if (const std::optional<SE3d> start = Start(each, initializers, &outcome)) {
      outcome.available = true;
      outcome.start = Difference(pair.truth(), *start);
      const tracker::AlignmentResult result = pair.Align(*start, refinement);
      outcome.end = Difference(pair.truth(), result.current_from_reference);
      outcome.success = result.ok && outcome.end.Within(kInitialized);
    }
    outcomes.push_back(outcome);
  }
  return outcomes;
}

StartSummary Summarize(StartMethod method, const std::vector<StartOutcome>& outcomes) {
  StartSummary summary;
  summary.method = method;
  std::vector<double> start_m, start_deg, end_m, end_deg, inliers, milliseconds;
  for (const StartOutcome& outcome : outcomes) {
    if (outcome.method != method) continue;
    ++summary.cases;
    summary.available += outcome.available;
    summary.successes += outcome.success;
    inliers.push_back(outcome.inliers);
    milliseconds.push_back(outcome.milliseconds);
    if (!outcome.available) continue;
    start_m.push_back(outcome.start.distance_m);
    start_deg.push_back(outcome.start.angle_deg);
    end_m.push_back(outcome.end.distance_m);
    end_deg.push_back(outcome.end.angle_deg);
  }
  summary.start = {MedianOrZero(start_m), MedianOrZero(start_deg)};
  summary.end = {MedianOrZero(end_m), MedianOrZero(end_deg)};
  summary.inliers = MedianOrZero(inliers);
  summary.milliseconds = MedianOrZero(milliseconds);
  return summary;
}

}  // namespace silt::experiments
