// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd/row_kernel.h"

namespace silt::tracker::simd {

Kernels Avx2Kernels() {
  using Rows = RowKernel<xsimd::avx2>;
  return {Rows::AddEquations, Rows::AddCost, Rows::AddRobustEquations, Rows::AddDepthEquations,
          Rows::CopyVisible};
}

}  // namespace silt::tracker::simd
