// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/pyramid.h"

#include "silt/core/pyramid_block.h"

namespace silt {
Image<float> HalvedIntensity(const Image<float>& intensity) {
  Image<float> half(intensity.width() / 2, intensity.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    const float* upper = intensity.row(2 * y);
    const float* lower = intensity.row(2 * y + 1);
    float* out = half.row(y);
    for (int x = 0; x < half.width(); ++x) {
      const int i = 2 * x;
      out[x] = MeanOfBlock(upper[i], upper[i + 1], lower[i], lower[i + 1]);
    }
  }
  return half;
}

Image<float> HalvedDepth(const Image<float>& depth_m) {
  Image<float> half(depth_m.width() / 2, depth_m.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    const float* upper = depth_m.row(2 * y);
    const float* lower = depth_m.row(2 * y + 1);
    float* out = half.row(y);
    for (int x = 0; x < half.width(); ++x) {
      const int i = 2 * x;
      out[x] = NearestSurface({upper[i], upper[i + 1], lower[i], lower[i + 1]});
    }
  }
  return half;
}

}  // namespace silt
