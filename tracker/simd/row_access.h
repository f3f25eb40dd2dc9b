// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <xsimd/xsimd.hpp>

namespace silt::tracker::simd {

// Batches of a row of `width` pixels from column x on, which may reach beyond its end: there, 0 is
// read and nothing is written.
template <typename Arch>
struct RowAccess {
  using Batch = xsimd::batch<float, Arch>;
  static constexpr int kBatch = int(Batch::size);

  [[gnu::always_inline]] static Batch Load(const float* row, int x, int width) {
    if (x + kBatch <= width) return Batch::load_unaligned(row + x);
    alignas(64) float lanes[kBatch] = {};
    for (int i = 0; x + i < width; ++i) lanes[i] = row[x + i];
    return Batch::load_aligned(lanes);
  }

  [[gnu::always_inline]] static void Store(const Batch& batch, float* row, int x, int width) {
    if (x + kBatch <= width) return batch.store_unaligned(row + x);
    alignas(64) float lanes[kBatch];
    batch.store_aligned(lanes);
    for (int i = 0; x + i < width; ++i) row[x + i] = lanes[i];
  }
};

}  // namespace silt::tracker::simd
