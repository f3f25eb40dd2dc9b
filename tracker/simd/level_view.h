// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/robust_loss.h"
#include "silt/tracker/sum_layout.h"

// What the files that are compiled once per instruction set share with the rest: plain data and
// plain functions. An inline function or a template used on both sides would be one symbol with two
// bodies, of which the linker keeps one, perhaps that of an instruction set which the processor
// lacks.
namespace silt::tracker::simd {

// Pixels of a row are summed in this many lanes, x mod kLanes, whatever the width of the
// processor's registers: every instruction set gives the same bits.
inline constexpr int kLanes = 16;

// kernel/robust_norm.h's.
struct RobustBounds {
  float inverse_gradient_squared, inverse_scale_squared, root_weight;
  RobustLoss loss;
};

// One level of a pair of images, row by row without padding, with a pose and a camera.
struct LevelView {
  int width, height;  // at least 2×2
  const float* reference_intensity;
  const float* reference_depth_m;
  const float* current_intensity;
  const float* current_depth_m;        // null where there is none
  const float* current_inverse_depth;  // NaN where unmeasured or beside an edge
  float rotation[9], translation[3];   // current_from_reference, row by row
  float fx, fy, cx, cy, inverse_fx, inverse_fy;
  RobustBounds intensity_norm, inverse_depth_norm;
  float gain, offset;  // of the reference's intensity
  bool fit_brightness;
  float reference_gradient;  // its share
  bool cubic;  // the intensity is interpolated over 4×4 pixels, and no level is smaller,
  float cubic_b, cubic_c;  // by this kernel of kernel/bicubic.h
};

// Sums over some rows, lane by lane: single precision within a row, double from row to row.
struct LaneSums {
  double value[kAllSumCount][kLanes] = {};
};

}  // namespace silt::tracker::simd
