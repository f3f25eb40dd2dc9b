// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd/row_kernel.h"

namespace silt::tracker::simd {

Kernels BaselineKernels() {
  using Rows = RowKernel<xsimd::default_arch>;
  return {Rows::AddEquations, Rows::AddCost, Rows::AddRobustEquations, Rows::AddDepthEquations,
          Rows::CopyVisible};
}

}  // namespace silt::tracker::simd
