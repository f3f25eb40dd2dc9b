// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/spline_coefficients.h"

#include <algorithm>
#include <cmath>

#include "silt/core/parallel.h"

namespace silt::tracker {
namespace {

constexpr int kLanes = 16;    // lines that are solved side by side
constexpr int kHorizon = 12;  // pole^12 is below a float's rounding

// `Lanes` lines of n values each, one value of every line beside the other, `stride` from one
// value to the next: solves c_{i−1} + 4·c_i + c_{i+1} = 6·f_i in place, by a causal and an
// anticausal filter.
template <int Lanes>
void Solve(float* c, int n, std::ptrdiff_t stride) {
  const float pole = float(std::sqrt(3.0) - 2), end = pole / (pole * pole - 1);
  float sum[Lanes] = {}, power = 1;
  for (int i = 0; i < std::min(n, kHorizon); ++i, power *= pole) {
    for (int k = 0; k < Lanes; ++k) sum[k] += power * c[i * stride + k];
  }
  std::copy_n(sum, Lanes, c);
  for (int i = 1; i < n; ++i) {
    float* at = c + i * stride;
    for (int k = 0; k < Lanes; ++k) at[k] += pole * (at - stride)[k];
  }
  float* last = c + (n - 1) * stride;
  for (int k = 0; k < Lanes; ++k) last[k] = end * (last[k] + pole * (last - stride)[k]);
  for (int i = n - 2; i >= 0; --i) {
    float* at = c + i * stride;
    for (int k = 0; k < Lanes; ++k) at[k] = pole * ((at + stride)[k] - at[k]);
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < Lanes; ++k) c[i * stride + k] *= 6;
  }
}

// Of all columns.
void SolveColumns(Image<float>* image) {
  const int width = image->width(), height = image->height();
  ParallelFor((width + kLanes - 1) / kLanes, [&](int block) {
    const int begin = block * kLanes;
    if (begin + kLanes <= width) return Solve<kLanes>(image->data() + begin, height, width);
    for (int x = begin; x < width; ++x) Solve<1>(image->data() + x, height, width);
  });
}

Image<float> Transposed(const Image<float>& image) {
  Image<float> turned(image.height(), image.width());
  ParallelFor((image.height() + kLanes - 1) / kLanes, [&](int block) {
    const int end = std::min(image.height(), (block + 1) * kLanes);
    for (int x = 0; x < image.width(); ++x) {
      for (int y = block * kLanes; y < end; ++y) turned(y, x) = image(x, y);
    }
  });
  return turned;
}

}  // namespace

Image<float> SplineCoefficients(const Image<float>& image) {
  if (image.width() < 2 || image.height() < 2) return image;
  Image<float> coefficients = Transposed(image);
  SolveColumns(&coefficients);
  coefficients = Transposed(coefficients);
  SolveColumns(&coefficients);
  return coefficients;
}

}  // namespace silt::tracker
