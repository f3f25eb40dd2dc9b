// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/tracker/sparse/feature.h"

namespace silt::tracker {

// SIFT (Lowe 2004) with 128 numbers, ORB (Rublee et al. 2011) with 256 bits or AKAZE (Alcantarilla
// et al. 2013) with 486, from OpenCV; the scale is its KeyPoint's size, a diameter.
std::vector<Feature> DetectOpencvFeatures(const Image<float>& intensity,
                                          const FeatureOptions& options);

}  // namespace silt::tracker
