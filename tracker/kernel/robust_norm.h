// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/residual.h"

namespace silt::tracker::kernel {

// What a residual r counts where its image's gradient has the length |∇I|:
//   ρ = ½·s·r²  with  s = 1/(a + r²/c²),  a = 1 + |∇I|²/g².
// This is Geman-McClure's norm of r/√a: the variance of a residual grows with the gradient, because
// neither image is sampled exactly where it seems to be, and a residual far above c says that the
// pixel shows something else. Both inverses 0: ρ = ½r².
template <typename T>
struct RobustNorm {
  T inverse_gradient_squared;  // 1/g², of intensity per pixel
  T inverse_scale_squared;     // 1/c², of intensity
  T root_weight = T(1);  // √ of a factor of ρ that makes different kinds of residuals comparable
};

template <typename T>
struct RobustWeight {
  T s;
  T root;  // √w, where w·r = dρ/dr with a held fixed: w = a·s², times the factor
};

template <typename T>
SILT_HOST_DEVICE inline RobustWeight<T> Weigh(const RobustNorm<T>& norm, const T& residual,
                                              const T& gradient_squared) {
  using std::sqrt;
  const T a = T(1) + gradient_squared * norm.inverse_gradient_squared;
  const T s = T(1) / (a + residual * residual * norm.inverse_scale_squared);
  return {s, norm.root_weight * (s * sqrt(a))};
}

// Gives residual and Jacobian their √w, and tells s·r².
template <typename T>
SILT_HOST_DEVICE inline T Weigh(const RobustNorm<T>& norm, LinearizedResidual<T>* r) {
  const RobustWeight<T> weight = Weigh(norm, r->residual, r->gradient_squared);
  const T robust_square = weight.s * (r->residual * r->residual);
  r->residual = weight.root * r->residual;
  for (T& j : r->jacobian) j = weight.root * j;
  return robust_square;
}

}  // namespace silt::tracker::kernel
