// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/se3.h"
#include "silt/tracker/kernel/ldlt6.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/sum_layout.h"

namespace silt::tracker {

// Whether intensities and inverse depths, each alone, want the same pose. A kind k has the optimum
// ξ_k and the covariance C_k = κ_k·H_k⁻¹, with κ_k = tr(H_k⁻¹·Σg·gᵀ)/6 of its stripes' gradients
// about their mean: the more its parts contradict each other, the larger; 1 for independent noise
// of the σ in units of which residuals are, and not less where they are better. With d = ξ_I − ξ_Z,
// χ² = dᵀ·(C_I + C_Z)⁻¹·d is 6 in the mean where noise alone parts them. Both kinds are looked at
// in turn, first where both together have led, and then where a step of its own leads either.
class ResidualAgreement {
 public:
  SILT_HOST_DEVICE void Begin(const SE3d& pose) {
    taken_ = 0;
    pose_[0] = pose_[1] = pose;
  }

  SILT_HOST_DEVICE bool done() const { return taken_ == 4; }
  // What is to be computed next: the residuals of this kind alone, each in units of its σ.
  SILT_HOST_DEVICE bool of_depth() const { return taken_ % 2 == 1; }
  SILT_HOST_DEVICE const SE3d& pose() const { return pose_[taken_ % 2]; }

  [[gnu::noinline]] SILT_HOST_DEVICE void Take(const NormalEquations& equations) {
    const int kind = taken_ % 2;
    for (int i = 0, k = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j, ++k) {
        // Just enough to leave directions alone that this kind does not tell.
        constexpr double damped = 1.001;
        const double h = equations.hessian[k];
        hessian_[kind][i][j] = hessian_[kind][j][i] = i == j ? damped * h : h;
      }
    }
    SetScatter(kind, equations);
    double d[6];
    for (int i = 0; i < 6; ++i) d[i] = -equations.gradient[i];
    kernel::Ldlt6(hessian_[kind]).Solve(d);
    bool near = true;
    for (const double x : d) near = near && std::abs(x) < 1;
    if (near) pose_[kind] = SE3d::Exp({{d[0], d[1], d[2]}, {d[3], d[4], d[5]}}) * pose_[kind];
    ++taken_;
  }

  // What an intensity counts for each depth, both in units of their σ, where χ² is above the bound:
  // C_I is multiplied by what brings χ² down to its mean (a variance component, Helmert's). 0: they
  // agree. Depths are metric; intensities owe it to the calibration of another camera.
  SILT_HOST_DEVICE double IntensityShare(double max_square) const {
    const double intensity = scattered_[0], depth = scattered_[1];
    if (!(Square(1) > max_square)) return 0;
    constexpr double mean_square = 6, step = 1.25, most = 1e4;
    double factor = 1;
    while (factor < most && Square(factor) > mean_square) factor *= step;
    return depth / (factor * intensity);
  }

 private:
  SILT_HOST_DEVICE void SetScatter(int kind, const NormalEquations& equations) {
    constexpr double free_share = double(kScatterStripes - 1) / kScatterStripes;
    const kernel::Ldlt6 ldlt(hessian_[kind]);
    double trace = 0;
    for (int j = 0; j < 6; ++j) {
      double column[6];
      for (int i = 0; i < 6; ++i) {
        const int row = i < j ? i : j, along = i < j ? j : i;
        const int k = row * 6 - row * (row - 1) / 2 + along - row;
        column[i] =
            equations.scatter[k] - equations.gradient[i] * equations.gradient[j] / kScatterStripes;
      }
      ldlt.Solve(column);
      trace += column[j];
    }
    const double kappa = trace / 6 / free_share;
    scattered_[kind] = kappa > 1 ? kappa : 1;
  }

  // χ² with `factor` times the covariance of the intensities.
  [[gnu::noinline]] SILT_HOST_DEVICE double Square(double factor) const {
    const kernel::Ldlt6 intensity(hessian_[0]), depth(hessian_[1]);
    double covariance[6][6];
    for (int j = 0; j < 6; ++j) {
      double a[6] = {}, b[6] = {};
      a[j] = factor * scattered_[0];
      b[j] = scattered_[1];
      intensity.Solve(a);
      depth.Solve(b);
      for (int i = 0; i < 6; ++i) covariance[i][j] = a[i] + b[i];
    }
    const Twistd apart = (pose_[0] * pose_[1].Inverse()).Log();
    const double d[6] = {apart.omega.x, apart.omega.y, apart.omega.z,
                         apart.v.x,     apart.v.y,     apart.v.z};
    double solved[6] = {d[0], d[1], d[2], d[3], d[4], d[5]}, square = 0;
    kernel::Ldlt6(covariance).Solve(solved);
    for (int i = 0; i < 6; ++i) square += d[i] * solved[i];
    return square;
  }

  int taken_ = 4;
  SE3d pose_[2];
  double hessian_[2][6][6] = {};
  double scattered_[2] = {};  // κ
};

}  // namespace silt::tracker
