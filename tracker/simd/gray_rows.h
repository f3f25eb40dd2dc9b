// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/color.h"
#include "silt/tracker/simd/batch.h"
#include "silt/tracker/simd/even_odd.h"
#include "silt/tracker/simd/preparation.h"
#include "silt/tracker/simd/rgb_words.h"
#include "silt/tracker/simd/row_access.h"

namespace silt::tracker::simd {

// GrayFromRgb, and HalvedIntensity of it, for one instruction set.
template <typename Arch>
class GrayRows {
 public:
  static void Full(const GrayView& view, int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const unsigned char* row = view.rgb + 3 * y * view.width;
      for (int x = 0; x < view.width; x += kBatch) {
        Access::Store(Gray(row, x, view.width), view.gray + y * view.width, x, view.width);
      }
    }
  }

  static void Halved(const GrayView& view, int begin, int end) {
    const int half_width = view.width / 2;
    for (int y = begin; y < end; ++y) {
      const unsigned char* upper = view.rgb + 6 * y * view.width;
      const unsigned char* lower = upper + 3 * view.width;
      for (int x = 0; x < half_width; x += kBatch) {
        const Pair a = Two(upper, x, view.width), b = Two(lower, x, view.width);
        Access::Store(Batch(0.25f) * ((a.even + a.odd) + (b.even + b.odd)),
                      view.gray + y * half_width, x, half_width);
      }
    }
  }

 private:
  using Batch = xsimd::batch<float, Arch>;
  using Words = xsimd::batch<std::int32_t, Arch>;
  using Access = RowAccess<Arch>;
  using Pair = EvenOdd<Arch>;
  static constexpr int kBatch = int(Batch::size);

  // Pixels [x, x + kBatch) of a row; those beyond its end are 0.
  [[gnu::always_inline]] static Batch Gray(const unsigned char* row, int x, int width) {
    if (x + kBatch <= width) return Gray(row + 3 * x);
    unsigned char rgb[3 * kBatch] = {};
    for (int i = 0; i < 3 * (width - x); ++i) rgb[i] = row[3 * x + i];
    return Gray(rgb);
  }

  [[gnu::always_inline]] static Batch Gray(const unsigned char* rgb) {
    const Words words = RgbWords<Arch>::Load(rgb), byte(255);
    return Luma(xsimd::to_float(words & byte), xsimd::to_float((words >> 8) & byte),
                xsimd::to_float((words >> 16) & byte)) /
           Batch(255.0f);
  }

  // The pixels of blocks [x, x + kBatch) in one row.
  [[gnu::always_inline]] static Pair Two(const unsigned char* row, int x, int width) {
    return Pair::Of(Gray(row, 2 * x, width), Gray(row, 2 * x + kBatch, width));
  }
};

}  // namespace silt::tracker::simd
