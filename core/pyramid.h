// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/core/image.h"

namespace silt {

// Each pixel of the result is the mean of a 2×2 block; an odd last column or row drops. The camera
// of the result is Pinhole::Halved().
Image<float> HalvedIntensity(const Image<float>& intensity);

// The same grid for depth. Only the nearest surface in the block counts: measurements that are no
// depth jump (depth_jump.h) away from the nearest one are averaged as inverse depths, which is
// exact for a plane; mixing over an edge would invent a surface between the two. 0: no measurement
// in the block.
Image<float> HalvedDepth(const Image<float>& depth_m);

// A measurement is a finite, positive depth.
SILT_HOST_DEVICE inline bool IsMeasured(float depth_m) { return depth_m > 0 && depth_m < 1e6f; }

}  // namespace silt
