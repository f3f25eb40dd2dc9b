// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/residual_scale.h"

#include <cmath>
#include <numbers>

namespace silt::tracker {

double MeanRobustSquare(double k) {
  // k²·E[e²/(k² + e²)] = k²·(1 − k²·E[1/(k² + e²)]), and the last expectation is
  // √(π/2)/k·exp(k²/2)·erfc(k/√2). Its factors leave the range of a double for large k, where the
  // series 1 − 3/k² + 15/k⁴ serves.
  if (k > 20) return 1 - 3 / (k * k) + 15 / (k * k * k * k);
  const double tail = std::exp(k * k / 2) * std::erfc(k / std::numbers::sqrt2);
  return k * k * (1 - k * std::sqrt(std::numbers::pi / 2) * tail);
}

double CurvatureLoss(double k) {
  constexpr double step = 0.05, end = 8;
  double weights = 0, slopes = 0;
  for (double e = step / 2; e < end; e += step) {
    const double q = 1 / (1 + e * e / (k * k)), density = std::exp(-e * e / 2);
    weights += q * q * density;
    slopes += q * q * q * (1 - 3 * e * e / (k * k)) * density;
  }
  return weights / slopes;
}

double ResidualScale(double mean_robust_square, double scale_factor) {
  const double beta = scale_factor > 0 ? MeanRobustSquare(scale_factor) : 1;
  return std::sqrt(mean_robust_square / beta);
}

}  // namespace silt::tracker
