// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "silt/core/host_device.h"

// The kernels are written once for a scalar T: float, double, ceres::Jet, or a SIMD batch, on the
// CPU and on the GPU. They do not branch on values: conditions are masks, and Select takes one of
// two values by a mask, both of which must be harmless to compute.
namespace silt::tracker::kernel {

// What comparing two T gives: bool for scalars, a mask of lanes for batches.
template <typename T>
using Mask = decltype(std::declval<T>() < std::declval<T>());

template <typename T>
SILT_HOST_DEVICE inline T Select(bool mask, const T& yes, const T& no) {
  return mask ? yes : no;
}

}  // namespace silt::tracker::kernel
