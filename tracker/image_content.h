// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::tracker {

// What a keyframe's images hold, against which an alignment with it is judged.
struct ImageContent {
  double measured_share = 0;      // of the pixels: those with a depth
  double variance = 0;            // of the intensity
  double mean_inverse_depth = 0;  // 1/m
  // How much more the intensity changes along a row where the depth jumps than beside there: twice
  // as much and more if colours are registered to depths, about as much if they are not. 0: there
  // are too few jumps to tell.
  double edge_contrast = 0;
};

// From every eighth row, which is enough for thresholds. All 0 where the depth is empty.
ImageContent ContentOf(const Image<Rgb8>& rgb, const Image<float>& depth_m);
ImageContent ContentOf(const Image<float>& intensity, const Image<float>& depth_m);

}  // namespace silt::tracker
