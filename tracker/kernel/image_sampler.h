// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/bilinear.h"

namespace silt::tracker::kernel {

// Where a kernel takes the pixels of an image from. A sampler for T has `width`, `height` and
// Taps<T> operator()(x, y) for integral x ∈ [0, width − 2], y ∈ [0, height − 2]; this one serves T
// = float and double, on the CPU and, with a device pointer, on the GPU.
template <typename T>
struct ImageSampler {
  const float* pixels;  // row by row, without padding
  int width, height;

  SILT_HOST_DEVICE Taps<T> operator()(const T& x, const T& y) const {
    const float* upper = pixels + int(y) * width + int(x);
    const float* lower = upper + width;
    return {T(upper[0]), T(upper[1]), T(lower[0]), T(lower[1])};
  }
};

}  // namespace silt::tracker::kernel
