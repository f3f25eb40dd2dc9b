// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/pyramid.h"

#include <algorithm>
#include <limits>

namespace silt {
namespace {

// Mean inverse depth of those of the four that lie on the nearest surface; 0 where none is
// measured.
float NearestSurface(const float (&block)[4], float same_surface) {
  float nearest = std::numeric_limits<float>::infinity();
  for (float z : block) {
    if (IsMeasured(z)) nearest = std::min(nearest, z);
  }
  float sum = 0;
  int count = 0;
  for (float z : block) {
    if (!IsMeasured(z) || z > nearest * (1 + same_surface)) continue;
    sum += 1 / z;
    ++count;
  }
  return count > 0 ? float(count) / sum : 0.0f;
}

}  // namespace

Image<float> HalvedIntensity(const Image<float>& intensity) {
  Image<float> half(intensity.width() / 2, intensity.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    const float* upper = intensity.row(2 * y);
    const float* lower = intensity.row(2 * y + 1);
    float* out = half.row(y);
    for (int x = 0; x < half.width(); ++x) {
      const int i = 2 * x;
      out[x] = 0.25f * ((upper[i] + upper[i + 1]) + (lower[i] + lower[i + 1]));
    }
  }
  return half;
}

Image<float> HalvedDepth(const Image<float>& depth_m, float same_surface) {
  Image<float> half(depth_m.width() / 2, depth_m.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    const float* upper = depth_m.row(2 * y);
    const float* lower = depth_m.row(2 * y + 1);
    float* out = half.row(y);
    for (int x = 0; x < half.width(); ++x) {
      const int i = 2 * x;
      out[x] = NearestSurface({upper[i], upper[i + 1], lower[i], lower[i + 1]}, same_surface);
    }
  }
  return half;
}

}  // namespace silt
