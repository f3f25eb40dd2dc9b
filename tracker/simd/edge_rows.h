// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "silt/core/depth_jump.h"
#include "silt/tracker/simd/batch.h"
// The kernels use what batch.h declares.
#include "silt/tracker/kernel/warp.h"
#include "silt/tracker/simd/preparation.h"
#include "silt/tracker/simd/row_access.h"

namespace silt::tracker::simd {

// depth_edges.h for one instruction set.
template <typename Arch>
class EdgeRows {
 public:
  static void Mark(const EdgeView& view, int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < view.width; x += kChunk) MarkChunk(view, x, y);
    }
  }

  static int Keep(const EdgeView& view, int begin, int end) {
    int measured = 0;
    for (int y = begin; y < end; ++y) measured += KeepRow(view, y);
    return measured;
  }

 private:
  using Batch = xsimd::batch<float, Arch>;
  using Access = RowAccess<Arch>;
  static constexpr int kBatch = int(Batch::size);
  static constexpr int kChunk = 320;  // pixels that are marked at once
  static constexpr int kSpan = kChunk + 2 * kMaxEdgeReach + 2 * kBatch;

  static void MarkChunk(const EdgeView& view, int begin, int y) {
    const int pixels = begin + kChunk < view.width ? kChunk : view.width - begin;
    alignas(64) float jump[kSpan];  // from `reach` columns before the chunk to as many behind it
    for (int i = 0; i < pixels + 2 * view.reach; i += kBatch) {
      JumpsAt(view, begin - view.reach + i, y).store_aligned(jump + i);
    }
    for (int x = 0; x < pixels; x += kBatch) {
      Batch mark = Batch::load_aligned(jump + x);
      for (int k = 1; k <= 2 * view.reach; ++k) {
        mark = xsimd::max(mark, Batch::load_unaligned(jump + x + k));
      }
      Access::Store(mark, view.marks + y * view.width, begin + x, view.width);
    }
  }

  // Of pixels [x, x + kBatch) of a row; those outside are like the nearest one inside: no jump.
  [[gnu::always_inline]] static Batch JumpsAt(const EdgeView& view, int x, int y) {
    const float* here = view.depth_m + y * view.width;
    const float* above = y > 0 ? here - view.width : here;
    const float* below = y + 1 < view.height ? here + view.width : here;
    if (x >= 1 && x + kBatch < view.width) return JumpsBeside(here + x, above + x, below + x);
    return JumpsAtEnd(view, x, {here, above, below});
  }

  struct Rows {
    const float *here, *above, *below;
  };
  [[gnu::noinline]] static Batch JumpsAtEnd(const EdgeView& view, int x, const Rows& rows) {
    float here[kBatch + 2], above[kBatch + 2], below[kBatch + 2];
    for (int i = 0; i < kBatch + 2; ++i) {
      int column = x - 1 + i;
      column = column < 0 ? 0 : column < view.width ? column : view.width - 1;
      here[i] = rows.here[column];
      above[i] = rows.above[column];
      below[i] = rows.below[column];
    }
    return JumpsBeside(here + 1, above + 1, below + 1);
  }

  // 1 where IsDepthJump of a depth and one of its four neighbours.
  [[gnu::always_inline]] static Batch JumpsBeside(const float* here, const float* above,
                                                  const float* below) {
    const Batch z = Batch::load_unaligned(here);
    const auto even =
        Even(z, Batch::load_unaligned(here - 1)) && Even(z, Batch::load_unaligned(here + 1)) &&
        Even(z, Batch::load_unaligned(above)) && Even(z, Batch::load_unaligned(below));
    return Select(even, Batch(0.0f), Batch(1.0f));
  }
  [[gnu::always_inline]] static kernel::Mask<Batch> Even(const Batch& a, const Batch& b) {
    return xsimd::abs(a - b) <= Batch(kDepthJump) * xsimd::min(a, b);
  }

  static int KeepRow(const EdgeView& view, int y) {
    const Batch zero(0.0f), one(1.0f), nan(std::numeric_limits<float>::quiet_NaN());
    const int row = y * view.width;
    Batch count = zero;
    for (int x = 0; x < view.width; x += kBatch) {
      const Batch depth = Access::Load(view.depth_m + row, x, view.width);
      const Batch kept = Select(MarkAround(view, x, y) > zero, zero, depth);
      const auto measured = kept > Batch(kernel::kMinDepth) && kept < Batch(kernel::kMaxDepth);
      count = count + Select(measured, one, zero);
      const auto store = [&](const Batch& values, float* to) {
        if (to) Access::Store(values, to + row, x, view.width);
      };
      store(kept, view.kept_m);
      store(Select(measured, one / Select(measured, kept, one), nan), view.inverse_depth);
      if (!view.kept_intensity) continue;
      const Batch intensity = Access::Load(view.intensity + row, x, view.width);
      store(Select(kept == zero && !(depth == zero), nan, intensity), view.kept_intensity);
    }
    return Total(count);
  }

  [[gnu::always_inline]] static Batch MarkAround(const EdgeView& view, int x, int y) {
    Batch mark(0.0f);
    if (!view.marks) return mark;
    const int last = y + view.reach < view.height ? y + view.reach : view.height - 1;
    for (int row = y > view.reach ? y - view.reach : 0; row <= last; ++row) {
      mark = xsimd::max(mark, Access::Load(view.marks + row * view.width, x, view.width));
    }
    return mark;
  }

  // Of whole numbers.
  static int Total(const Batch& count) {
    alignas(64) float lanes[kBatch];
    count.store_aligned(lanes);
    float total = 0;
    for (const float lane : lanes) total += lane;
    return int(total);
  }
};

}  // namespace silt::tracker::simd
