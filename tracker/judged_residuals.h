// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "silt/tracker/backend.h"
#include "silt/tracker/residual_norm.h"

// The residuals that a pose is judged by: see PoseEvidence::inlier_ratio.
namespace silt::tracker {

// Residuals up to this are what noise leaves, and steep gradients excuse more, see
// kernel/robust_norm.h.
inline constexpr double kInlierBound = 20.0 / 255;

inline ResidualNorm JudgedNorm(const Brightness& brightness = {}) {
  ResidualNorm norm;
  norm.brightness = brightness;
  norm.intensity.scale = kInlierBound;
  norm.intensity.gradient = 8.0 / 255;
  return norm;
}

// A quarter of the size does, and takes a sixteenth of the time; where that has too few pixels or
// was not kept, another level that was.
inline int JudgedLevel(const ReferencePyramid& reference) {
  const auto measured = [&](int level) { return reference.levels()[level].measured_pixels; };
  const int coarsest = int(reference.levels().size()) - 1;
  int level = std::min(2, coarsest);
  while (level < coarsest && measured(level) == 0) ++level;
  while (level > 0 && measured(level) < 1000 && measured(level - 1) > 0) --level;
  return level;
}

}  // namespace silt::tracker
