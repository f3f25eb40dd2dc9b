// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::cuda {

// What the device that is current reaches in kernels that do nothing else.
struct Ceilings {
  double bytes_per_s = 0;              // read and written, by a copy
  double operations_per_s = 0;         // single precision, a fused multiply-add counted as two
  double operations_no_fma_per_s = 0;  // a multiplication and an addition apart, as silt's kernels
};

// The best of several runs, timed by events. Throws silt::Error where there is no device.
Ceilings MeasureCeilings();

}  // namespace silt::cuda
