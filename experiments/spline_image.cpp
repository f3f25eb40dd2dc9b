// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/spline_image.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

// β(i − t) for i = −1 … 2.
struct Weights {
  double w[4];

  explicit Weights(double t) {
    const double s = 1 - t;
    w[0] = s * s * s / 6;
    w[1] = 2.0 / 3 - t * t * (2 - t) / 2;
    w[2] = 2.0 / 3 - s * s * (2 - s) / 2;
    w[3] = t * t * t / 6;
  }
};

// Solves c_{i−1} + 4 c_i + c_{i+1} = 6 f_i in place along a line of n values, by a causal and an
// anticausal filter with the pole z = √3 − 2 (Unser 1999).
void Solve(double* c, int n, std::ptrdiff_t stride) {
  const double z = std::sqrt(3.0) - 2;
  constexpr int kHorizon = 40;  // z^40 = 1e-23
  double sum = 0, power = 1;
  for (int i = 0; i < std::min(n, kHorizon); ++i, power *= z) sum += power * c[i * stride];
  c[0] = sum;
  for (int i = 1; i < n; ++i) c[i * stride] += z * c[(i - 1) * stride];
  const std::ptrdiff_t last = (n - 1) * stride;
  c[last] = z / (z * z - 1) * (c[last] + z * c[last - stride]);
  for (int i = n - 2; i >= 0; --i) c[i * stride] = z * (c[(i + 1) * stride] - c[i * stride]);
  for (int i = 0; i < n; ++i) c[i * stride] *= 6;
}

}  // namespace

SplineImage::SplineImage(const Image<float>& values)
    : coefficients_(values.width(), values.height()) {
  SILT_CHECK(values.width() >= 2 && values.height() >= 2);
  std::copy(values.begin(), values.end(), coefficients_.begin());
  for (int y = 0; y < values.height(); ++y) Solve(coefficients_.row(y), values.width(), 1);
  for (int x = 0; x < values.width(); ++x) {
    Solve(coefficients_.data() + x, values.height(), values.width());
  }
}

double SplineImage::At(double u, double v) const {
  const int x = int(u), y = int(v);
  const Weights across(u - x), down(v - y);
  double sum = 0;
  for (int j = 0; j < 4; ++j) {
    const double* c = coefficients_.row(y - 1 + j) + x - 1;
    sum += down.w[j] *
           (across.w[0] * c[0] + across.w[1] * c[1] + across.w[2] * c[2] + across.w[3] * c[3]);
  }
  return sum;
}

}  // namespace silt::experiments
