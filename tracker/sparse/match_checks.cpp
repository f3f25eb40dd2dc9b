// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/match_checks.h"

#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "silt/core/error.h"
#include "silt/tracker/sparse/patch_correlation.h"

namespace silt::tracker {

void MatchCheckOptions::Validate() const {
  if (!(distance_factor >= 1)) throw Error("match checks: distance_factor must be at least 1");
  if (!(distance_floor >= 0)) throw Error("match checks: distance_floor must not be negative");
  if (!(min_correlation >= -1 && min_correlation < 1)) {
    throw Error("match checks: min_correlation must lie in [-1, 1)");
  }
  if (patch_radius < 1) throw Error("match checks: patch_radius must be at least 1");
  if (!(epipolar_px > 0)) throw Error("match checks: epipolar_px must be positive");
  if (!(epipolar_confidence > 0 && epipolar_confidence < 1)) {
    throw Error("match checks: epipolar_confidence must lie between 0 and 1");
  }
}

std::vector<FeatureMatch> KeepNearMatches(const std::vector<FeatureMatch>& matches,
                                          const MatchCheckOptions& options) {
  float smallest = std::numeric_limits<float>::infinity();
  for (const FeatureMatch& match : matches) smallest = std::min(smallest, match.distance);
  const double limit = std::max(options.distance_factor * double(smallest), options.distance_floor);
  std::vector<FeatureMatch> kept;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(kept),
               [&](const FeatureMatch& match) { return double(match.distance) <= limit; });
  return kept;
}

std::vector<FeatureMatch> KeepCorrelatedMatches(const std::vector<FeatureMatch>& matches,
                                                const ImageFeatures& keyframe,
                                                const ImageFeatures& current,
                                                const MatchCheckOptions& options) {
  const auto alike = [&](const FeatureMatch& match) {
    const Feature& a = keyframe.features[std::size_t(match.keyframe)];
    const Feature& b = current.features[std::size_t(match.current)];
    return PatchCorrelation(keyframe.intensity, {a.pixel, a.angle_rad, 1}, current.intensity,
                            {b.pixel, b.angle_rad, b.scale / a.scale},
                            options.patch_radius) > options.min_correlation;
  };
  std::vector<FeatureMatch> kept;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(kept), alike);
  return kept;
}

std::vector<FeatureMatch> KeepEpipolarMatches(const std::vector<FeatureMatch>& matches,
                                              const std::vector<Feature>& keyframe,
                                              const std::vector<Feature>& current,
                                              const MatchCheckOptions& options) {
  constexpr std::size_t kLeast = 8;
  if (matches.size() < kLeast) return {};
  std::vector<cv::Point2d> from, to;
  for (const FeatureMatch& match : matches) {
    const Vec2d& a = keyframe[std::size_t(match.keyframe)].pixel;
    const Vec2d& b = current[std::size_t(match.current)].pixel;
    from.emplace_back(a.x, a.y);
    to.emplace_back(b.x, b.y);
  }
  // OpenCV's RANSAC seeds itself anew in each call: the same matches give the same inliers.
  std::vector<unsigned char> inlier;
  const cv::Mat fundamental = cv::findFundamentalMat(from, to, cv::FM_RANSAC, options.epipolar_px,
                                                     options.epipolar_confidence, inlier);
  if (fundamental.empty() || inlier.size() != matches.size()) return {};
  std::vector<FeatureMatch> kept;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (inlier[i] != 0) kept.push_back(matches[i]);
  }
  return kept;
}

}  // namespace silt::tracker
