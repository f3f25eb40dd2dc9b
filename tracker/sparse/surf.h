// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/tracker/sparse/feature.h"

namespace silt::tracker {

// SURF (Bay, Ess, Tuytelaars, Van Gool 2008) with 64 numbers; the scale is σ of the Gaussian that
// the box filter stands for, at least 2. A feature within 32 scales of the border has no descriptor
// and is left out.
std::vector<Feature> DetectSurf(const Image<float>& intensity, const FeatureOptions& options = {});

}  // namespace silt::tracker
