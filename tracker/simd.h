// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <xsimd/xsimd.hpp>

#include "silt/tracker/kernel/bilinear.h"

// What tracker/kernel needs of a SIMD batch beyond arithmetic. Include before the kernels: they
// find Select by the batch's own namespace.
namespace xsimd {

template <typename T, typename Arch>
inline batch<T, Arch> Select(const batch_bool<T, Arch>& mask, const batch<T, Arch>& yes,
                             const batch<T, Arch>& no) {
  return select(mask, yes, no);
}

}  // namespace xsimd

namespace silt::tracker {

using FloatBatch = xsimd::batch<float>;
inline constexpr int kLanes = int(FloatBatch::size);

// kernel/image_sampler.h for a batch of coordinates.
struct BatchSampler {
  const float* pixels;
  int width, height;

  kernel::Taps<FloatBatch> operator()(const FloatBatch& x, const FloatBatch& y) const {
    alignas(64) float columns[kLanes], rows[kLanes];
    alignas(64) float taps[4][kLanes];
    x.store_aligned(columns);
    y.store_aligned(rows);
    for (int i = 0; i < kLanes; ++i) {
      const float* upper = pixels + int(rows[i]) * width + int(columns[i]);
      const float* lower = upper + width;
      taps[0][i] = upper[0];
      taps[1][i] = upper[1];
      taps[2][i] = lower[0];
      taps[3][i] = lower[1];
    }
    return {FloatBatch::load_aligned(taps[0]), FloatBatch::load_aligned(taps[1]),
            FloatBatch::load_aligned(taps[2]), FloatBatch::load_aligned(taps[3])};
  }
};

}  // namespace silt::tracker
