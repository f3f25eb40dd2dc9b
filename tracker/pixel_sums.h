// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "silt/core/host_device.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/residual_norm.h"
#include "silt/tracker/sum_layout.h"

// What the sums over pixels of sum_layout.h mean, for every backend.
namespace silt::tracker {

// 1/x², where 0 stands for infinity.
SILT_HOST_DEVICE inline float InverseSquare(double x) { return x > 0 ? float(1 / (x * x)) : 0.0f; }

// kernel/robust_norm.h's, or what a backend passes in its place.
template <typename Norm>
SILT_HOST_DEVICE inline Norm FloatNorm(const RobustBounds& bounds) {
  return {InverseSquare(bounds.gradient), InverseSquare(bounds.scale),
          float(std::sqrt(bounds.weight)), bounds.loss};
}

// ½Σr² (eq. 8), from kSumCount sums.
SILT_HOST_DEVICE inline PhotometricCost CostOf(const double* sums) {
  return {0.5 * sums[kSquaresSum], std::int64_t(sums[kCountSum]), sums[kSquaresSum]};
}

// Of kSumCount sums; the scatter is left at zero.
SILT_HOST_DEVICE inline NormalEquations EquationsOf(const double* sums, const ResidualNorm& norm) {
  NormalEquations equations;
  for (int k = 0; k < kGradientSum; ++k) equations.hessian[k] = sums[k];
  for (int k = 0; k < 6; ++k) equations.gradient[k] = sums[kGradientSum + k];
  equations.cost = CostOf(sums);
  if (!norm.robust()) return equations;
  equations.intensity = {sums[kRobustSum], std::int64_t(sums[kCountSum])};
  equations.inverse_depth = {sums[kDepthRobustSum], std::int64_t(sums[kDepthCountSum])};
  equations.cost.sum = 0.5 * (norm.intensity.weight * equations.intensity.squares +
                              norm.inverse_depth.weight * equations.inverse_depth.squares);
  return equations;
}

// The gain and the offset of kernel/brightness.h, from its sums; where all pixels have about the
// same intensity the gain stays.
inline Brightness FitBrightness(const double* sums, const Brightness& before) {
  const double w = sums[0], wi = sums[1], wii = sums[2], wr = sums[3], wri = sums[4];
  if (!(w > 0)) return before;
  constexpr double kLeastVariance = 1e-5, kLeastGain = 0.05, kMostGain = 20;
  const double variance = wii / w - wi / w * (wi / w);
  const double change = variance > kLeastVariance ? (wri / w - wi / w * (wr / w)) / variance : 0;
  const double gain = std::clamp(before.gain + change, kLeastGain, kMostGain);
  return {gain, before.offset + (wr - (gain - before.gain) * wi) / w};
}

// Element k of g·gᵀ of the gradient g of the stripe that begins with tile `first`, in the order of
// NormalEquations::scatter; `tile_sums` holds `stride` of each tile, kSumCount first.
SILT_HOST_DEVICE inline double ScatterOf(const double* tile_sums, int tiles, int first, int k,
                                         int stride = kSumCount) {
  int row = 0;
  for (; k >= 6 - row; ++row) k -= 6 - row;
  const int end = first + TilesOfStripe(tiles) < tiles ? first + TilesOfStripe(tiles) : tiles;
  double g = 0, h = 0;
  for (int tile = first; tile < end; ++tile) {
    g += tile_sums[tile * stride + kGradientSum + row];
    h += tile_sums[tile * stride + kGradientSum + row + k];
  }
  return g * h;
}

}  // namespace silt::tracker
