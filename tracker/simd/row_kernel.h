// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "silt/tracker/simd/batch.h"
// The kernels use what batch.h declares.
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"
#include "silt/tracker/kernel/visibility.h"
#include "silt/tracker/simd/kernels.h"

namespace silt::tracker::simd {

// The sums of rows for one instruction set. Everything here has Arch in its name, for the reason
// told in level_view.h. A row is worked off in chunks that stay in the first-level cache: first the
// residuals and Jacobians of all pixels, then their products, with the sums in registers.
template <typename Arch>
class RowKernel {
 public:
  static void AddEquations(const LevelView& view, int begin, int end, LaneSums* sums) {
    RowKernel(view).template AddRows<Residuals::kSquares>(begin, end, sums);
  }
  static void AddRobustEquations(const LevelView& view, int begin, int end, LaneSums* sums) {
    RowKernel(view).template AddRows<Residuals::kRobust>(begin, end, sums);
  }
  static void AddDepthEquations(const LevelView& view, int begin, int end, LaneSums* sums) {
    RowKernel(view).template AddRows<Residuals::kRobustWithDepth>(begin, end, sums);
  }

  static void AddCost(const LevelView& view, int begin, int end, LaneSums* sums) {
    const RowKernel kernel(view);
    for (int y = begin; y < end; ++y) {
      RowSums row;
      kernel.AddCostOfRow(y, &row);
      Add(row.value[kSquaresSum], sums->value[kSquaresSum]);
      Add(row.value[kCountSum], sums->value[kCountSum]);
    }
  }

  static void CopyVisible(const LevelView& view, int begin, int end, float* depth_m) {
    const RowKernel kernel(view);
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < view.width; x += kBatch) {
        alignas(64) float visible[kBatch];
        kernel.VisibleDepth(x, y).store_aligned(visible);
        float* out = depth_m + y * view.width + x;
        for (int i = 0; i < kBatch && x + i < view.width; ++i) out[i] = visible[i];
      }
    }
  }

 private:
  enum class Residuals { kSquares, kRobust, kRobustWithDepth };
  using Batch = xsimd::batch<float, Arch>;
  static constexpr int kBatch = int(Batch::size);
  static constexpr int kChunk = 20 * kLanes;  // pixels
  // Of the columns of J and r, but for r², which counts without the weight of a robust norm.
  static constexpr int kProducts = kSquaresSum;
  // AVX-512 keeps all 27 sums in its 32 registers; others have 16 and go over a chunk twice.
  static constexpr int kProductsAtOnce = kBatch == 16 ? kProducts : 14;

  // The columns of J, and r: 0 where there is no residual.
  struct Chunk {
    alignas(64) float column[7][kChunk];
  };
  struct RowSums {
    alignas(64) float value[kSumCount][kLanes] = {};
  };

  explicit RowKernel(const LevelView& view)
      : view_(view),
        warp_(MakeWarp(view)),
        intensity_{view.current_intensity, view.width, view.height},
        inverse_depth_{view.current_inverse_depth, view.width, view.height},
        intensity_norm_(MakeNorm(view.intensity_norm)),
        inverse_depth_norm_(MakeNorm(view.inverse_depth_norm)),
        columns_(Columns()),
        padded_width_((view.width + kLanes - 1) / kLanes * kLanes) {}

  static kernel::Warp<Batch> MakeWarp(const LevelView& view) {
    kernel::Warp<Batch> warp;
    for (int i = 0; i < 3; ++i) {
      const float* row = view.rotation + 3 * i;
      warp.rotation.row[i] = {Batch(row[0]), Batch(row[1]), Batch(row[2])};
    }
    const float* t = view.translation;
    warp.translation = {Batch(t[0]), Batch(t[1]), Batch(t[2])};
    warp.camera = {Batch(view.fx), Batch(view.fy), Batch(view.cx),
                   Batch(view.cy), view.width,     view.height};
    warp.inverse_fx = Batch(view.inverse_fx);
    warp.inverse_fy = Batch(view.inverse_fy);
    return warp;
  }

  static kernel::RobustNorm<Batch> MakeNorm(const RobustBounds& bounds) {
    return {Batch(bounds.inverse_gradient_squared), Batch(bounds.inverse_scale_squared),
            Batch(bounds.root_weight)};
  }

  static Batch Columns() {
    alignas(64) float columns[kBatch];
    for (int i = 0; i < kBatch; ++i) columns[i] = float(i);
    return Batch::load_aligned(columns);
  }

  // Pixels [x, x + kBatch) of a row; those beyond its end are 0, which as a depth is no
  // measurement.
  [[gnu::always_inline]] static Batch Load(const float* row, int x, int width) {
    if (x + kBatch <= width) return Batch::load_unaligned(row + x);
    alignas(64) float lanes[kBatch] = {};
    for (int i = 0; x + i < width; ++i) lanes[i] = row[x + i];
    return Batch::load_aligned(lanes);
  }

  [[gnu::always_inline]] kernel::ReferencePixel<Batch> Pixels(int x, int y) const {
    return {Batch(float(x)) + columns_, Batch(float(y)),
            Load(view_.reference_depth_m + y * view_.width, x, view_.width),
            Load(view_.reference_intensity + y * view_.width, x, view_.width)};
  }

  template <Residuals kKind>
  void AddRows(int begin, int end, LaneSums* sums) const {
    for (int y = begin; y < end; ++y) {
      RowSums row;
      for (int x = 0; x < padded_width_; x += kChunk) AddChunk<kKind>(x, y, &row);
      for (int k = 0; k < kSumCount; ++k) Add(row.value[k], sums->value[k]);
    }
  }

  template <Residuals kKind>
  void AddChunk(int begin, int y, RowSums* row) const {
    const int end = begin + kChunk < padded_width_ ? begin + kChunk : padded_width_;
    Chunk intensity, inverse_depth;
    for (int x = begin; x < end; x += kBatch) {
      LinearizePixels<kKind>(x, y, &intensity, &inverse_depth, row);
    }
    AddAllProducts(intensity, end - begin, row);
    if constexpr (kKind == Residuals::kRobustWithDepth) {
      AddAllProducts(inverse_depth, end - begin, row);
    }
  }

  // A batch of pixels; the columns of a robust norm are √w·J and √w·r.
  template <Residuals kKind>
  [[gnu::flatten]] void LinearizePixels(int x, int y, Chunk* intensity, Chunk* inverse_depth,
                                        RowSums* row) const {
    const int lane = x % kLanes, at = x % kChunk;
    const kernel::ReferencePixel<Batch> pixel = Pixels(x, y);
    const kernel::WarpedPixel<Batch> warped = kernel::WarpPixel(warp_, pixel);
    kernel::LinearizedResidual<Batch> r =
        kernel::LinearizeIntensity(warp_, warped, intensity_, pixel.intensity);
    Add(r.residual * r.residual, row->value[kSquaresSum] + lane);
    Add(Ones(r.valid), row->value[kCountSum] + lane);
    if constexpr (kKind != Residuals::kSquares) {
      Add(kernel::Weigh(intensity_norm_, &r), row->value[kRobustSum] + lane);
    }
    Store(r, at, intensity);
    if constexpr (kKind == Residuals::kRobustWithDepth) {
      kernel::LinearizedResidual<Batch> d =
          kernel::LinearizeInverseDepth(warp_, warped, inverse_depth_);
      Add(Ones(d.valid), row->value[kDepthCountSum] + lane);
      Add(kernel::Weigh(inverse_depth_norm_, &d), row->value[kDepthRobustSum] + lane);
      Store(d, at, inverse_depth);
    }
  }

  static Batch Ones(const kernel::Mask<Batch>& mask) {
    return Select(mask, Batch(1.0f), Batch(0.0f));
  }

  static void Store(const kernel::LinearizedResidual<Batch>& r, int at, Chunk* chunk) {
    for (int i = 0; i < 6; ++i) r.jacobian[i].store_aligned(chunk->column[i] + at);
    r.residual.store_aligned(chunk->column[6] + at);
  }

  static void AddAllProducts(const Chunk& chunk, int pixels, RowSums* row) {
    for (int lane = 0; lane < kLanes; lane += kBatch) {
      AddProducts<0>(chunk, lane, pixels, row, FirstProducts{});
      if constexpr (kProductsAtOnce < kProducts) {
        AddProducts<kProductsAtOnce>(chunk, lane, pixels, row, OtherProducts{});
      }
    }
  }

  // Adds the products First + K… of the lanes [lane, lane + kBatch).
  using FirstProducts = std::make_integer_sequence<int, kProductsAtOnce>;
  using OtherProducts = std::make_integer_sequence<int, kProducts - kProductsAtOnce>;
  template <int First, int... K>
  static void AddProducts(const Chunk& chunk, int lane, int pixels, RowSums* row,
                          std::integer_sequence<int, K...>) {
    Batch sums[] = {Batch::load_aligned(row->value[First + K] + lane)...};
    for (int x = lane; x < pixels; x += kLanes) {
      const auto column = [&](int i) { return Batch::load_aligned(chunk.column[i] + x); };
      ((sums[K] = sums[K] + column(Left(First + K)) * column(Right(First + K))), ...);
    }
    (sums[K].store_aligned(row->value[First + K] + lane), ...);
  }

  // The columns whose product is sum k: see kSquaresSum.
  static constexpr int Left(int k) {
    if (k >= 21) return k - 21;
    int row = 0;
    for (; k >= 6 - row; ++row) k -= 6 - row;
    return row;
  }
  static constexpr int Right(int k) {
    if (k >= 21) return 6;
    int row = 0;
    for (; k >= 6 - row; ++row) k -= 6 - row;
    return row + k;
  }

  // The reference's depth, or 0 where the current image shows something nearer in its place.
  [[gnu::flatten]] Batch VisibleDepth(int x, int y) const {
    const kernel::ReferencePixel<Batch> pixel = Pixels(x, y);
    const kernel::WarpedPixel<Batch> warped = kernel::WarpPixel(warp_, pixel);
    const kernel::LandingPixel<Batch> landing = kernel::Land(warped, view_.width, view_.height);
    const Batch seen_m = NearestCurrentDepth(landing.x, landing.y);
    return Select(kernel::IsHidden(warped, landing, seen_m), Batch(0.0f), pixel.depth_m);
  }

  Batch NearestCurrentDepth(const Batch& x, const Batch& y) const {
    using Indices = xsimd::batch<std::int32_t, Arch>;
    alignas(64) std::int32_t at[kBatch];
    alignas(64) float values[kBatch];
    (xsimd::to_int(y) * Indices(view_.width) + xsimd::to_int(x)).store_aligned(at);
    for (int i = 0; i < kBatch; ++i) values[i] = view_.current_depth_m[at[i]];
    return Batch::load_aligned(values);
  }

  [[gnu::flatten]] void AddCostOfRow(int y, RowSums* row) const {
    for (int x = 0; x < padded_width_; x += kBatch) {
      kernel::Mask<Batch> valid;
      const Batch residual = kernel::Residual(warp_, intensity_, Pixels(x, y), &valid);
      Add(residual * residual, row->value[kSquaresSum] + x % kLanes);
      Add(Ones(valid), row->value[kCountSum] + x % kLanes);
    }
  }

  static void Add(const Batch& batch, float* sum) {
    (Batch::load_aligned(sum) + batch).store_aligned(sum);
  }
  static void Add(const float* row, double* sum) {
    for (int i = 0; i < kLanes; ++i) sum[i] += double(row[i]);
  }

  const LevelView& view_;
  const kernel::Warp<Batch> warp_;
  const BatchSampler<Arch> intensity_, inverse_depth_;
  const kernel::RobustNorm<Batch> intensity_norm_, inverse_depth_norm_;
  const Batch columns_;  // 0, 1, 2, …
  const int padded_width_;
};

}  // namespace silt::tracker::simd
