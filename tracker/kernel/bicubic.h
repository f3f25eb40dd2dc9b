// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/bilinear.h"

namespace silt::tracker::kernel {

// The weight of a pixel at the distance |x| from a point: one of the cubics of Mitchell & Netravali
// (1988) by their B and C,
//   near(x) = 1 − B/3 + (2B + C − 3)·x² + (2 − 3B/2 − C)·x³             for x in [0, 1],
//   far(x − 1), far(y) = B/6 − (B/2 + C)·y + (B/2 + 2C)·y² − (B/6 + C)·y³ for x in [1, 2].
// B = 0, C = ½ is that of Catmull-Rom, which goes through the pixels; B = 1, C = 0 is the cubic
// B-spline, for an image of coefficients.
template <typename T>
struct CubicKernel {
  T near0, near2, near3, far0, far1, far2, far3;

  SILT_HOST_DEVICE CubicKernel(float b, float c)
      : near0(1 - b / 3),
        near2(2 * b + c - 3),
        near3(2 - 1.5f * b - c),
        far0(b / 6),
        far1(-0.5f * b - c),
        far2(0.5f * b + 2 * c),
        far3(-b / 6 - c) {}

  SILT_HOST_DEVICE T Near(const T& x) const { return near0 + x * x * (near2 + x * near3); }
  SILT_HOST_DEVICE T NearSlope(const T& x) const { return x * (T(2) * near2 + x * (T(3) * near3)); }
  SILT_HOST_DEVICE T Far(const T& y) const { return far0 + y * (far1 + y * (far2 + y * far3)); }
  SILT_HOST_DEVICE T FarSlope(const T& y) const {
    return far1 + y * (T(2) * far2 + y * (T(3) * far3));
  }
};

// The 4×4 pixels around a point, row by row: v[1][1] is the one before it in either direction.
template <typename T>
struct CubicTaps {
  static constexpr int kMargin = 1;  // pixels that must lie beyond the inner four
  T v[4][4];
  const CubicKernel<T>* kernel;
};

// Of four pixels in a line, for a point at a ∈ [0, 1) between the inner two, and by a.
template <typename T>
struct CubicWeights {
  T weight[4], slope[4];

  SILT_HOST_DEVICE CubicWeights(const CubicKernel<T>& k, const T& a)
      : CubicWeights(k, a, T(1) - a) {}

 private:
  SILT_HOST_DEVICE CubicWeights(const CubicKernel<T>& k, const T& a, const T& rest)
      : weight{k.Far(a), k.Near(a), k.Near(rest), k.Far(rest)},
        slope{k.FarSlope(a), k.NearSlope(a), -k.NearSlope(rest), -k.FarSlope(rest)} {}
};

// The polynomial Σ w_j(b)·w_i(a)·v_ji and its exact derivatives.
template <typename T>
SILT_HOST_DEVICE inline Sample<T> Interpolate(const CubicTaps<T>& taps, const T& a, const T& b) {
  const CubicWeights<T> across(*taps.kernel, a), down(*taps.kernel, b);
  const T zero(0);
  Sample<T> sum{zero, zero, zero};
  for (int j = 0; j < 4; ++j) {
    T value = zero, slope = zero;
    for (int i = 0; i < 4; ++i) {
      value = value + across.weight[i] * taps.v[j][i];
      slope = slope + across.slope[i] * taps.v[j][i];
    }
    sum.value = sum.value + down.weight[j] * value;
    sum.du = sum.du + down.weight[j] * slope;
    sum.dv = sum.dv + down.slope[j] * value;
  }
  return sum;
}

}  // namespace silt::tracker::kernel
