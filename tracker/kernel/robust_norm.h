// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/robust_loss.h"

namespace silt::tracker::kernel {

// What a residual r counts where its image's gradient has the length |∇I|:
//   ρ = ½·s·r²  with  s = f(e²)/a,  e² = r²/(a·c²),  a = 1 + |∇I|²/g².
// The variance of a residual grows with the gradient, because neither image is sampled exactly
// where it seems to be, and a residual far above c says that the pixel shows something else:
//   Geman-McClure  f = 1/(1 + e²)
//   Huber          f = 1 up to |e| = 1, then (2|e| − 1)/e²
//   Tukey          f = (1 − (1 − e²)³)/(3e²) up to |e| = 1, then 1/(3e²)
//   Student's t    f = log(1 + e²)/e², of c²/σ² degrees of freedom
// Both inverses 0: ρ = ½r².
template <typename T>
struct RobustNorm {
  T inverse_gradient_squared;  // 1/g², of intensity per pixel
  T inverse_scale_squared;     // 1/c², of intensity
  T root_weight = T(1);  // √ of a factor of ρ that makes different kinds of residuals comparable
  RobustLoss loss = RobustLoss::kGemanMcClure;
};

template <typename T>
struct RobustWeight {
  T s;
  T root;  // √w, where w·r = dρ/dr with a held fixed, times the factor
};

// log(1 + x)/x for x ≥ 0, relatively to 1e-5 up to x = 1e4, by roots and quotients alone, which are
// the same on every processor: log(1 + x) = 2·log(1 + x/(1 + √(1 + x))), and in the end its series.
template <typename T>
SILT_HOST_DEVICE inline T LogShare(T x) {
  using std::sqrt;
  T share(1);
  for (int i = 0; i < 5; ++i) {
    const T step = T(1) / (T(1) + sqrt(T(1) + x));
    share = share * (step + step);
    x = x * step;
  }
  const T t = x / (T(2) + x), t2 = t * t;
  return share * (T(2) / (T(2) + x)) * (T(1) + t2 * (T(1) / T(3) + t2 * (T(1) / T(5))));
}

// f(e²), and √(w·a): those that are not the presets'.
template <typename T>
SILT_HOST_DEVICE inline RobustWeight<T> WeighOtherwise(RobustLoss loss, const T& e2) {
  using std::sqrt;
  const T one(1);
  const Mask<T> small = e2 < one;
  if (loss == RobustLoss::kHuber) {
    const T q = Select(small, one, one / sqrt(e2));
    return {(q + q) - q * q, sqrt(q)};
  }
  if (loss == RobustLoss::kTukey) {
    const T t = Select(small, one - e2, T(0)), share = Select(small, one, one / e2);
    return {share * (one + t + t * t) * (one / T(3)), t};
  }
  return {LogShare(e2), one / sqrt(one + e2)};
}

template <typename T>
SILT_HOST_DEVICE inline RobustWeight<T> Weigh(const RobustNorm<T>& norm, const T& residual,
                                              const T& gradient_squared) {
  using std::sqrt;
  const T a = T(1) + gradient_squared * norm.inverse_gradient_squared;
  if (norm.loss != RobustLoss::kGemanMcClure) {
    const T e2 = residual * residual * norm.inverse_scale_squared / a;
    const RobustWeight<T> weight = WeighOtherwise(norm.loss, e2);
    return {weight.s / a, norm.root_weight * (weight.root / sqrt(a))};
  }
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
