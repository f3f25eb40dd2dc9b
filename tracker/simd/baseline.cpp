// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd/row_kernel.h"
// The rows use what row_kernel.h declares.
#include "silt/tracker/simd/edge_rows.h"
#include "silt/tracker/simd/gray_rows.h"
#include "silt/tracker/simd/halve_rows.h"

namespace silt::tracker::simd {

Kernels BaselineKernels() {
  using Rows = RowKernel<xsimd::default_arch>;
  return {Rows::AddEquations, Rows::AddCost, Rows::AddRobustEquations, Rows::AddDepthEquations,
          Rows::CopyVisible};
}

PreparationKernels BaselinePreparation() {
  using Gray = GrayRows<xsimd::default_arch>;
  using Halve = HalveRows<xsimd::default_arch>;
  using Edges = EdgeRows<xsimd::default_arch>;
  return {Gray::Full, Gray::Halved, Halve::Intensity, Halve::Depth, Edges::Mark, Edges::Keep};
}

}  // namespace silt::tracker::simd
