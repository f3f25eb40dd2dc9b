// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/image.h"
#include "silt/tracker/kernel/bicubic.h"

namespace silt::tracker::kernel {

// kernel/image_sampler.h's for 4×4 pixels and T = double, or a T made of one.
template <typename T = double>
struct CubicImageSampler {
  const Image<float>& image;
  CubicKernel<T> kernel;
  int width = image.width(), height = image.height();

  CubicTaps<T> operator()(const T& x, const T& y) const { return At(int(Value(x)), int(Value(y))); }

  CubicTaps<T> At(int x, int y) const {
    CubicTaps<T> taps;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) taps.v[j][i] = T(double(image(x - 1 + i, y - 1 + j)));
    }
    taps.kernel = &kernel;
    return taps;
  }

  Sample<T> Between(double u, double v) const {
    return Interpolate(At(int(u), int(v)), T(u - std::floor(u)), T(v - std::floor(v)));
  }

 private:
  static double Value(double x) { return x; }
  template <typename Jet>
  static double Value(const Jet& x) {
    return x.a;
  }
};

}  // namespace silt::tracker::kernel
