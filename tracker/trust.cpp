// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/trust.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "silt/tracker/judged_residuals.h"
#include "silt/tracker/pose_covariance.h"

namespace silt::tracker {
namespace {

// 1 − mean(s·r²)/c²: a residual counts as an outlier by r²/(a·c² + r²).
double InlierRatio(const Backend& backend, const ImagePair& pair,
                   const AlignmentResult& alignment) {
  const NormalEquations::Spread spread =
      alignment.judged
          ? *alignment.judged
          : backend
                .Linearize(pair, JudgedLevel(pair.reference), alignment.current_from_reference,
                           JudgedNorm(alignment.brightness))
                .intensity;
  if (spread.count == 0) return 0;
  return 1 - spread.squares / double(spread.count) / (kInlierBound * kInlierBound);
}

struct Bounds {
  double max_unexplained_variance, max_depth_disagreement, min_inlier_ratio, min_overlap,
      max_uncertainty_rad;
};

// Why the evidence does not hold up, in words; nothing where it does. Fails for NaN as well.
std::optional<std::string> Objection(const PoseEvidence& e, const Bounds& bounds) {
  char text[120];
  if (!(e.unexplained_variance <= bounds.max_unexplained_variance)) {
    return "the aligned images do not look alike";
  }
  if (!(e.depth_disagreement <= bounds.max_depth_disagreement)) return "the aligned depths differ";
  if (!(e.inlier_ratio >= bounds.min_inlier_ratio)) {
    std::snprintf(text, sizeof text, "%.0f %% of the pixels agree", 100 * e.inlier_ratio);
    return text;
  }
  if (!(e.overlap >= bounds.min_overlap)) {
    std::snprintf(text, sizeof text, "%.0f %% of the keyframe is seen", 100 * e.overlap);
    return text;
  }
  if (!(e.uncertainty_rad <= bounds.max_uncertainty_rad)) {
    std::snprintf(text, sizeof text, "the images determine the pose to %.2g rad only",
                  e.uncertainty_rad);
    return text;
  }
  return std::nullopt;
}

// Fails for NaN: what is not known is in doubt.
double Ratio(double value, double bound) {
  if (bound > 0 && value <= HUGE_VAL) return value / bound;
  return value <= bound ? 1 : HUGE_VAL;
}

}  // namespace

const char* Name(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::kTracked:
      return "tracked";
    case TrackingStatus::kDoubtful:
      return "doubtful";
    case TrackingStatus::kLost:
      break;
  }
  return "lost";
}

PoseEvidence EvidenceOf(const Backend& backend, const ReferenceViews& references,
                        const CurrentPyramid& current, const AlignmentResult& alignment,
                        const ImageContent& content) {
  const AlignmentLevel& finest = alignment.levels.back();
  double measured = 0;
  for (const ReferenceView& reference : references) {
    measured += reference.pyramid.levels()[finest.level - 1].measured_pixels;
  }
  PoseEvidence evidence;
  evidence.overlap = double(finest.final_cost.pixels) / std::max(measured, 1.0);
  // As the current exposure has it: a picture of nothing is matched by a gain near 0.
  const double gain = alignment.brightness.gain;
  evidence.unexplained_variance =
      finest.final_cost.mean_square() / (gain * gain * content.variance);
  evidence.depth_disagreement = alignment.inverse_depth_scale / content.mean_inverse_depth;
  evidence.inlier_ratio = InlierRatio(backend, {references.front().pyramid, current}, alignment);
  evidence.uncertainty_rad = LargestDeviation(alignment.covariance, content.mean_inverse_depth);
  return evidence;
}

Judgement Judge(const PoseEvidence& evidence, const TrustOptions& options) {
  // Too small an overlap is a failure of the alignment itself.
  const Bounds lost{options.max_unexplained_variance, options.max_depth_disagreement,
                    options.min_inlier_ratio, 0, options.max_uncertainty_rad};
  const Bounds doubtful{options.doubtful_unexplained_variance, options.doubtful_depth_disagreement,
                        options.doubtful_inlier_ratio, options.doubtful_overlap,
                        options.doubtful_uncertainty_rad};
  if (const auto why = Objection(evidence, lost)) return {TrackingStatus::kLost, "lost: " + *why};
  if (const auto why = Objection(evidence, doubtful)) {
    return {TrackingStatus::kDoubtful, "doubtful: " + *why};
  }
  return {TrackingStatus::kTracked, ""};
}

double Doubt(const PoseEvidence& e, const TrustOptions& options) {
  return std::max({Disagreement(e, options), Ratio(options.doubtful_overlap, e.overlap),
                   Ratio(e.uncertainty_rad, options.doubtful_uncertainty_rad)});
}

double Disagreement(const PoseEvidence& e, const TrustOptions& options) {
  return std::max({Ratio(e.unexplained_variance, options.doubtful_unexplained_variance),
                   Ratio(e.depth_disagreement, options.doubtful_depth_disagreement),
                   Ratio(1 - e.inlier_ratio, 1 - options.doubtful_inlier_ratio)});
}

}  // namespace silt::tracker
