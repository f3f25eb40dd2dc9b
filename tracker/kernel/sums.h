// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/scalar.h"

namespace silt::tracker::kernel {

inline constexpr int kHessianSize = 21;  // upper triangle of JᵀJ, row by row
inline constexpr int kGradientSize = 6;  // Jᵀr
inline constexpr int kSumCount = kHessianSize + kGradientSize + 2;  // and Σr², count

// What eq. 17 and the cost need of a set of pixels.
template <typename T>
struct CostSums {
  T squares = T(0);  // Σr²
  T count = T(0);

  SILT_HOST_DEVICE void Add(const T& residual, const Mask<T>& valid) {
    squares = squares + residual * residual;
    count = count + Select(valid, T(1), T(0));
  }
};

template <typename T>
struct Sums {
  T hessian[kHessianSize];
  T gradient[kGradientSize];
  CostSums<T> cost;

  SILT_HOST_DEVICE Sums() {
    for (T& h : hessian) h = T(0);
    for (T& g : gradient) g = T(0);
  }

  SILT_HOST_DEVICE void Add(const LinearizedResidual<T>& pixel) {
    int k = 0;
    for (int i = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j, ++k) {
        hessian[k] = hessian[k] + pixel.jacobian[i] * pixel.jacobian[j];
      }
      gradient[i] = gradient[i] + pixel.jacobian[i] * pixel.residual;
    }
    cost.Add(pixel.residual, pixel.valid);
  }
};

}  // namespace silt::tracker::kernel
