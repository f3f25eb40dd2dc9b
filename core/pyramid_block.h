// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/depth_jump.h"
#include "silt/core/host_device.h"
#include "silt/core/pyramid.h"

// One pixel of a pyramid from the 2×2 block below it, for every backend.
namespace silt {

SILT_HOST_DEVICE inline float MeanOfBlock(float v00, float v10, float v01, float v11) {
  return 0.25f * ((v00 + v10) + (v01 + v11));
}

// Mean inverse depth of those of the four that lie on the nearest surface; 0 where none is
// measured. No two of them are a jump apart, as none is from the nearest.
SILT_HOST_DEVICE inline float NearestSurface(const float (&block_m)[4]) {
  float nearest = 0;
  for (const float z : block_m) {
    if (IsMeasured(z) && (nearest == 0 || z < nearest)) nearest = z;
  }
  float sum = 0;
  int count = 0;
  for (const float z : block_m) {
    if (!IsMeasured(z) || IsDepthJump(nearest, z)) continue;
    sum += 1 / z;
    ++count;
  }
  return count > 0 ? float(count) / sum : 0.0f;
}

}  // namespace silt
