// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

// When light is let in.
struct Shutter {
  double exposure_s = 0;  // 0: an instant
  int time_samples = 16;  // at least so many instants where exposure_s > 0
};

// One sharp picture of those whose mean is the frame: all pixels are sampled at the same instant
// and at the same place within the pixel.
struct ShutterSample {
  double time_s;  // relative to mid-exposure, in (−exposure/2, exposure/2)
  Vec2d offset;   // from the pixel's centre, in (−½, ½)²
};

// The mean of the times and of the offsets is 0: a frame is an average about its own pose.
std::vector<ShutterSample> ShutterSamples(int samples_per_pixel, const Shutter& shutter);

}  // namespace silt::sim
