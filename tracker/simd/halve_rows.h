// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "silt/core/depth_jump.h"
#include "silt/tracker/simd/batch.h"
// The kernels use what batch.h declares.
#include "silt/tracker/kernel/warp.h"
#include "silt/tracker/simd/even_odd.h"
#include "silt/tracker/simd/preparation.h"
#include "silt/tracker/simd/row_access.h"

namespace silt::tracker::simd {

// core/pyramid.h for one instruction set.
template <typename Arch>
class HalveRows {
 public:
  static void Intensity(const HalvedView& view, int begin, int end) {
    Rows(view, begin, end, [](const Pair& upper, const Pair& lower) {
      return Batch(0.25f) * ((upper.even + upper.odd) + (lower.even + lower.odd));
    });
  }

  static void Depth(const HalvedView& view, int begin, int end) {
    Rows(view, begin, end, [](const Pair& upper, const Pair& lower) {
      return NearestSurface({upper.even, upper.odd, lower.even, lower.odd});
    });
  }

 private:
  using Batch = xsimd::batch<float, Arch>;
  using Access = RowAccess<Arch>;
  using Pair = EvenOdd<Arch>;
  static constexpr int kBatch = int(Batch::size);

  struct Block {
    Batch z[4];
  };

  template <typename Halve>
  [[gnu::always_inline]] static void Rows(const HalvedView& view, int begin, int end,
                                          const Halve& halve) {
    const int half_width = view.width / 2;
    for (int y = begin; y < end; ++y) {
      const float* upper = view.fine + 2 * y * view.width;
      const float* lower = upper + view.width;
      for (int x = 0; x < half_width; x += kBatch) {
        Access::Store(halve(Two(upper, x, view.width), Two(lower, x, view.width)),
                      view.half + y * half_width, x, half_width);
      }
    }
  }

  // The pixels of blocks [x, x + kBatch) in one row.
  [[gnu::always_inline]] static Pair Two(const float* row, int x, int width) {
    return Pair::Of(Access::Load(row, 2 * x, width), Access::Load(row, 2 * x + kBatch, width));
  }

  // Mean inverse depth of those that are no jump away from the nearest; 0 where none is measured.
  [[gnu::always_inline]] static Batch NearestSurface(const Block& block) {
    const Batch zero(0.0f), one(1.0f), infinity(std::numeric_limits<float>::infinity());
    Batch nearest = infinity, sum = zero, count = zero;
    for (const Batch& z : block.z) nearest = xsimd::min(nearest, Select(Measured(z), z, infinity));
    const Batch jump = Batch(kDepthJump) * nearest;
    for (const Batch& z : block.z) {
      const auto counts = Measured(z) && z - nearest <= jump;
      sum = sum + Select(counts, one / Select(counts, z, one), zero);
      count = count + Select(counts, one, zero);
    }
    const auto any = count > zero;
    return Select(any, count / Select(any, sum, one), zero);
  }

  [[gnu::always_inline]] static kernel::Mask<Batch> Measured(const Batch& z) {
    return z > Batch(kernel::kMinDepth) && z < Batch(kernel::kMaxDepth);
  }
};

}  // namespace silt::tracker::simd
