// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "silt/core/se3.h"

namespace silt::tracker {

// How far two poses of a graph disagree with what was measured of them:
//   e = W·Log(Z·(T_w,to⁻¹·T_w,from)⁻¹),  WᵀW = C⁻¹,
// where Z = to_from_from as measured, the truth being exp(ξ)·Z with ξ of covariance C. The poses
// are T_w = T_w⁰·exp(δ), and the parameters their δ = (ω, v). For any scalar: e of the right ones
// has 6 numbers of variance 1.
struct EdgeError {
  SE3d measured;                        // Z
  SE3d world_from_from, world_from_to;  // T_w⁰
  std::array<double, 36> whitening;     // W, row by row

  template <typename T>
  bool operator()(const T* from_delta, const T* to_delta, T* error) const {
    const SE3<T> from = Moved(world_from_from, from_delta), to = Moved(world_from_to, to_delta);
    const Twist<T> xi = (measured.Cast<T>() * from.Inverse() * to).Log();
    const T values[6] = {xi.omega.x, xi.omega.y, xi.omega.z, xi.v.x, xi.v.y, xi.v.z};
    for (int i = 0; i < 6; ++i) {
      error[i] = T(0.0);
      for (int j = 0; j < 6; ++j) error[i] += T(whitening[6 * i + j]) * values[j];
    }
    return true;
  }

  template <typename T>
  static SE3<T> Moved(const SE3d& pose, const T* delta) {
    return pose.Cast<T>() *
           SE3<T>::Exp({{delta[0], delta[1], delta[2]}, {delta[3], delta[4], delta[5]}});
  }
};

}  // namespace silt::tracker
