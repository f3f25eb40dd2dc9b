// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/simd/batch.h"
// The kernels use what batch.h declares.
#include "silt/tracker/kernel/bicubic.h"

namespace silt::tracker::simd {

// A sampler of 4×4 pixels for a batch of coordinates, none of them of the image's first or last
// column or row.
template <typename Arch>
struct CubicBatchSampler {
  using Batch = xsimd::batch<float, Arch>;

  BatchSampler<Arch> pairs;
  kernel::CubicKernel<Batch> kernel;
  int width = pairs.width, height = pairs.height;

  kernel::CubicTaps<Batch> operator()(const Batch& x, const Batch& y) const {
    alignas(64) std::int32_t at[Batch::size];
    pairs.IndexOf(x, y).store_aligned(at);
    return TapsAt(at);
  }

  kernel::CubicTaps<Batch> TapsAt(const std::int32_t* at) const {
    kernel::CubicTaps<Batch> taps;
    for (int j = 0; j < 4; ++j) {
      const float* row = pairs.pixels + (j - 1) * width;
      const auto left = pairs.PairsAt(row - 1, at), right = pairs.PairsAt(row + 1, at);
      taps.v[j][0] = left.left;
      taps.v[j][1] = left.right;
      taps.v[j][2] = right.left;
      taps.v[j][3] = right.right;
    }
    taps.kernel = &kernel;
    return taps;
  }
};

}  // namespace silt::tracker::simd
