// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::tracker {

// A square patch of (2·radius + 1)² samples, `spacing_px` apart, centred on `pixel`.
struct Patch {
  Vec2d pixel;
  double angle_rad = 0;  // of the patch's own x axis
  double spacing_px = 1;
};

// Correlation index of two patches, in [−1, 1]:
//   Σ(a − ā)(b − b̄) / √(Σ(a − ā)²·Σ(b − b̄)²),
// sampled bilinearly. −1, that is never alike, where a patch leaves its image or is constant.
double PatchCorrelation(const Image<float>& a, const Patch& in_a, const Image<float>& b,
                        const Patch& in_b, int radius);

}  // namespace silt::tracker
