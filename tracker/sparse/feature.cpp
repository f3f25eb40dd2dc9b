// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/feature.h"

#include "silt/core/error.h"
#include "silt/tracker/sparse/opencv_features.h"
#include "silt/tracker/sparse/surf.h"

namespace silt::tracker {

void FeatureOptions::Validate() const {
  if (max_features < 1) throw Error("features: max_features must be at least 1");
  if (!(surf_threshold > 0)) throw Error("features: surf_threshold must be positive");
  if (!(sift_contrast > 0)) throw Error("features: sift_contrast must be positive");
  if (orb_fast_threshold < 1) throw Error("features: orb_fast_threshold must be at least 1");
  if (!(akaze_threshold > 0)) throw Error("features: akaze_threshold must be positive");
}

std::vector<Feature> DetectFeatures(const Image<float>& intensity, const FeatureOptions& options) {
  return options.kind == FeatureKind::kSurf ? DetectSurf(intensity, options)
                                            : DetectOpencvFeatures(intensity, options);
}

}  // namespace silt::tracker
