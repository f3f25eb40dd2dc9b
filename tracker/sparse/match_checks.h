// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/image.h"
#include "silt/tracker/sparse/feature.h"
#include "silt/tracker/sparse/feature_match.h"

// The three checks of §3.2 on matches between keyframe and current image. Each returns the matches
// that pass, in their order.
namespace silt::tracker {

struct MatchCheckOptions {
  // 1. distance ≤ factor × the smallest distance among the matches.
  double distance_factor = 5;
  // The paper's threshold closes on nothing when one pair of descriptors agrees by chance, or when
  // both images are the same: a threshold below this floor is raised to it.
  double distance_floor = 0.25;

  // 2. correlation index of the patches around the two features, each turned with its feature and
  // the current one stretched by the ratio of their scales. Of 267 right matches under a roll of
  // 30°, upright patches keep 76, turned ones 256.
  double min_correlation = 0.7;
  int patch_radius = 8;

  // 3. distance to the epipolar line of the fundamental matrix found by RANSAC.
  double epipolar_px = 2;
  double epipolar_confidence = 0.99;

  // Throws silt::Error where an option is out of range.
  void Validate() const;
};

// An image and its features, which the checks look into.
struct ImageFeatures {
  const Image<float>& intensity;
  const std::vector<Feature>& features;
};

std::vector<FeatureMatch> KeepNearMatches(const std::vector<FeatureMatch>& matches,
                                          const MatchCheckOptions& options = {});

std::vector<FeatureMatch> KeepCorrelatedMatches(const std::vector<FeatureMatch>& matches,
                                                const ImageFeatures& keyframe,
                                                const ImageFeatures& current,
                                                const MatchCheckOptions& options = {});

// Nothing passes where fewer than 8 matches come in, or where no matrix can be found.
std::vector<FeatureMatch> KeepEpipolarMatches(const std::vector<FeatureMatch>& matches,
                                              const std::vector<Feature>& keyframe,
                                              const std::vector<Feature>& current,
                                              const MatchCheckOptions& options = {});

}  // namespace silt::tracker
