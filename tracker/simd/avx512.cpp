// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd/row_kernel.h"
// The rows use what row_kernel.h declares.
#include "silt/tracker/simd/edge_rows.h"
#include "silt/tracker/simd/gray_rows.h"
#include "silt/tracker/simd/halve_rows.h"

namespace silt::tracker::simd {

Kernels Avx512Kernels() {
  using Rows = RowKernel<xsimd::avx512f>;
  return {Rows::AddEquations, Rows::AddCost, Rows::AddRobustEquations, Rows::AddDepthEquations,
          Rows::CopyVisible};
}

PreparationKernels Avx512Preparation() {
  using Gray = GrayRows<xsimd::avx512f>;
  using Halve = HalveRows<xsimd::avx512f>;
  using Edges = EdgeRows<xsimd::avx512f>;
  return {Gray::Full, Gray::Halved, Halve::Intensity, Halve::Depth, Edges::Mark, Edges::Keep};
}

}  // namespace silt::tracker::simd
