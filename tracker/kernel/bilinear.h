// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"

namespace silt::tracker::kernel {

// The four pixels around a point: v10 lies one column right of v00, v01 one row below it.
template <typename T>
struct Taps {
  static constexpr int kMargin = 0;  // pixels that must lie beyond the four
  T v00, v10, v01, v11;
};

// An interpolated value and its derivatives by column and row, per pixel.
template <typename T>
struct Sample {
  T value, du, dv;
};

// The polynomial v00 + a·(v10 − v00) + b·(v01 − v00) + a·b·(v11 − v10 − v01 + v00) for
// (a, b) ∈ [0, 1)², and its exact derivatives.
template <typename T>
SILT_HOST_DEVICE inline Sample<T> Bilinear(const Taps<T>& taps, const T& a, const T& b) {
  const T upper = taps.v10 - taps.v00;
  const T lower = taps.v11 - taps.v01;
  const T left = taps.v01 - taps.v00;
  const T twist = lower - upper;
  const T du = upper + b * twist;
  return {taps.v00 + b * left + a * du, du, left + a * twist};
}

template <typename T>
SILT_HOST_DEVICE inline Sample<T> Interpolate(const Taps<T>& taps, const T& a, const T& b) {
  return Bilinear(taps, a, b);
}

}  // namespace silt::tracker::kernel
