// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"

namespace silt::tracker::kernel {

// The reference's intensity as the current exposure would have it: gain·I + offset.
template <typename T>
struct Exposed {
  T gain, offset;
  SILT_HOST_DEVICE T operator()(const T& intensity) const { return gain * intensity + offset; }
};

// What a pixel adds to the equations of the gain and the offset that fit better,
// min Σ w·(r − δgain·I − δoffset)² with the norm's weights w at r: w, w·I, w·I², w·r and w·r·I.
template <typename T>
struct BrightnessTerms {
  T value[5];
};

template <typename T>
SILT_HOST_DEVICE inline BrightnessTerms<T> TermsOf(const RobustNorm<T>& norm,
                                                   const WarpedSample<T>& current,
                                                   const T& intensity, const Exposed<T>& exposed) {
  const T zero(0);
  const auto sampled = [&](const T& x) { return Select(current.valid, x, zero); };
  const T residual = sampled(current.sample.value - exposed(intensity));
  const T du = sampled(current.sample.du), dv = sampled(current.sample.dv);
  const T root = Weigh(norm, residual, du * du + dv * dv).root;
  const T weight = sampled(root * root), weighted = weight * residual;
  return {
      {weight, weight * intensity, weight * intensity * intensity, weighted, weighted * intensity}};
}

}  // namespace silt::tracker::kernel
