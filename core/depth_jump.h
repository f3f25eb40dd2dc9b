// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/host_device.h"

namespace silt {

// Share of the nearer depth: well above the slope of a surface from one pixel to the next, well
// below the gap between two objects. What is left out beside edges and what is averaged into
// pyramids both go by it.
inline constexpr float kDepthJump = 0.03f;

// Whether two neighbouring depths lie on different surfaces. Holes differ from everything but
// holes.
SILT_HOST_DEVICE inline bool IsDepthJump(float a_m, float b_m) {
  using std::abs;
  return !(abs(a_m - b_m) <= kDepthJump * (b_m < a_m ? b_m : a_m));
}

}  // namespace silt
