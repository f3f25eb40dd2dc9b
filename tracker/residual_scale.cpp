// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/residual_scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/tracker/kernel/robust_norm.h"

namespace silt::tracker {
namespace {

// E[value(e, weight of e)] by the midpoint rule, which is all but exact for smooth values.
template <typename Value>
double Mean(RobustLoss loss, double k, const Value& value) {
  const double step = 0.05 * std::min(1.0, k), end = 8;
  const kernel::RobustNorm<double> norm{0, 1 / (k * k), 1, loss};
  double sum = 0;
  for (double e = step / 2; e < end; e += step) {
    sum += value(e, kernel::Weigh(norm, e, 0.0)) * std::exp(-e * e / 2);
  }
  return sum * step * std::sqrt(2 / std::numbers::pi);
}

double Weight(double, const kernel::RobustWeight<double>& weight) {
  return weight.root * weight.root;
}

}  // namespace

double MeanRobustSquare(RobustLoss loss, double k) {
  return Mean(loss, k, [](double e, const auto& weight) { return weight.s * e * e; });
}

double CurvatureLoss(RobustLoss loss, double k) {
  // E[ψ'] = E[e·ψ] of a standard normal e (Stein).
  return Mean(loss, k, Weight) /
         Mean(loss, k, [](double e, const auto& weight) { return e * e * Weight(e, weight); });
}

double ResidualScale(RobustLoss loss, double mean_robust_square, double scale_factor) {
  const double beta = scale_factor > 0 ? MeanRobustSquare(loss, scale_factor) : 1;
  return std::sqrt(mean_robust_square / beta);
}

}  // namespace silt::tracker
