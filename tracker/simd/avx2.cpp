// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd/row_kernel.h"
// The rows use what row_kernel.h declares.
#include "silt/tracker/simd/edge_rows.h"
#include "silt/tracker/simd/gray_rows.h"
#include "silt/tracker/simd/halve_rows.h"

namespace silt::tracker::simd {

Kernels Avx2Kernels() {
  using Rows = RowKernel<xsimd::avx2>;
  return {Rows::AddEquations, Rows::AddCost, Rows::AddRobustEquations, Rows::AddDepthEquations,
          Rows::CopyVisible};
}

PreparationKernels Avx2Preparation() {
  using Gray = GrayRows<xsimd::avx2>;
  using Halve = HalveRows<xsimd::avx2>;
  using Edges = EdgeRows<xsimd::avx2>;
  return {Gray::Full, Gray::Halved, Halve::Intensity, Halve::Depth, Edges::Mark, Edges::Keep};
}

}  // namespace silt::tracker::simd
