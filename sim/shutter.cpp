// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/shutter.h"

#include <algorithm>

#include "silt/core/error.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

std::vector<ShutterSample> ShutterSamples(int samples_per_pixel, const Shutter& shutter) {
  SILT_CHECK(samples_per_pixel >= 1 && shutter.exposure_s >= 0);
  const bool blurred = shutter.exposure_s > 0;
  const int n = blurred ? std::max(samples_per_pixel, shutter.time_samples) : samples_per_pixel;
  const std::vector<Vec2d> offsets = SquareSamples(n);
  std::vector<ShutterSample> samples;
  for (int k = 0; k < n; ++k) {
    samples.push_back(
        {shutter.exposure_s * ((k + 0.5) / n - 0.5), offsets[std::size_t(k)] - Vec2d{0.5, 0.5}});
  }
  return samples;
}

}  // namespace silt::sim
