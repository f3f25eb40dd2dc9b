// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "silt/tracker/simd/batch.h"
// The kernels use what batch.h declares.
#include "silt/tracker/kernel/brightness.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"
#include "silt/tracker/kernel/visibility.h"
#include "silt/tracker/simd/cubic_sampler.h"
#include "silt/tracker/simd/kernels.h"

namespace silt::tracker::simd {

// The sums of rows for one instruction set. Everything here has Arch in its name, for the reason
// told in level_view.h. A row is worked off in chunks that stay in the first-level cache, in
// several passes: where pixels land; the images there; residuals and Jacobians; at last their
// products, with the sums in registers. One pass would be a chain of so many operations that
// processors find no others to do while they wait for each.
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
      if (view.cubic) {
        kernel.AddCostOfRow(kernel.cubic_intensity_, y, &row);
      } else {
        kernel.AddCostOfRow(kernel.intensity_, y, &row);
      }
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

  // Where the pixels of a chunk land.
  struct Landings {
    alignas(64) float x[kChunk], y[kChunk], z[kChunk], inverse_z[kChunk];  // of the point
    alignas(64) float a[kChunk], b[kChunk];                                // kernel::ImagePoint's
    alignas(64) std::int32_t index[kChunk];                                // of its x and y
  };
  // An image there.
  struct Samples {
    alignas(64) float value[kChunk], du[kChunk], dv[kChunk];
  };
  // The columns of J, and r: 0 where there is no residual.
  struct Chunk {
    alignas(64) float column[7][kChunk];
  };
  struct RowSums {
    alignas(64) float value[kAllSumCount][kLanes] = {};
  };

  explicit RowKernel(const LevelView& view)
      : view_(view),
        warp_(MakeWarp(view)),
        intensity_{view.current_intensity, view.width, view.height},
        inverse_depth_{view.current_inverse_depth, view.width, view.height},
        cubic_intensity_{intensity_, {view.cubic_b, view.cubic_c}},
        intensity_norm_(MakeNorm(view.intensity_norm)),
        inverse_depth_norm_(MakeNorm(view.inverse_depth_norm)),
        exposed_{Batch(view.gain), Batch(view.offset)},
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
            Batch(bounds.root_weight), bounds.loss};
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
      const int all = view_.fit_brightness ? kAllSumCount : kSumCount;
      for (int k = 0; k < all; ++k) Add(row.value[k], sums->value[k]);
    }
  }

  template <Residuals kKind>
  void AddChunk(int begin, int y, RowSums* row) const {
    const int end = begin + kChunk < padded_width_ ? begin + kChunk : padded_width_;
    Landings landings;
    Samples samples;
    Chunk chunk;
    WarpPixels(begin, end, y, &landings);
    if (view_.cubic) {
      SamplePixels(cubic_intensity_, landings, end - begin, &samples);
    } else {
      SamplePixels(intensity_, landings, end - begin, &samples);
    }
    if (view_.reference_gradient > 0) MixGradients({begin, end, y}, &samples);
    LinearizeIntensities<kKind>({begin, end, y}, landings, samples, &chunk, row);
    if (view_.fit_brightness) AddBrightness({begin, end, y}, samples, row);
    AddAllProducts(chunk, end - begin, row);
    if constexpr (kKind == Residuals::kRobustWithDepth) {
      SamplePixels(inverse_depth_, landings, end - begin, &samples);
      LinearizeDepths(end - begin, landings, samples, &chunk, row);
      AddAllProducts(chunk, end - begin, row);
    }
  }

  [[gnu::flatten, gnu::noinline]] void WarpPixels(int begin, int end, int y, Landings* to) const {
    for (int x = begin, at = 0; x < end; x += kBatch, at += kBatch) {
      const kernel::WarpedPixel<Batch> warped = kernel::WarpPixel(warp_, Pixels(x, y));
      const kernel::ImagePoint<Batch> point =
          kernel::Locate(warped, view_.width, view_.height, view_.cubic ? 1 : 0);
      warped.point.x.store_aligned(to->x + at);
      warped.point.y.store_aligned(to->y + at);
      warped.point.z.store_aligned(to->z + at);
      warped.inverse_z.store_aligned(to->inverse_z + at);
      point.a.store_aligned(to->a + at);
      point.b.store_aligned(to->b + at);
      intensity_.IndexOf(point.x, point.y).store_aligned(to->index + at);
    }
  }

  template <typename Sampler>
  [[gnu::flatten, gnu::noinline]] static void SamplePixels(const Sampler& sampler,
                                                           const Landings& landings, int pixels,
                                                           Samples* to) {
    for (int at = 0; at < pixels; at += kBatch) {
      const kernel::Sample<Batch> sample = kernel::Interpolate(
          sampler.TapsAt(landings.index + at), Batch::load_aligned(landings.a + at),
          Batch::load_aligned(landings.b + at));
      sample.value.store_aligned(to->value + at);
      sample.du.store_aligned(to->du + at);
      sample.dv.store_aligned(to->dv + at);
    }
  }

  // What the first passes left of a batch of pixels.
  static kernel::WarpedPixel<Batch> WarpedAt(const Landings& landings, int at) {
    const auto load = [&](const float* values) { return Batch::load_aligned(values + at); };
    return {{load(landings.x), load(landings.y), load(landings.z)},
            load(landings.inverse_z),
            {},
            {},
            {}};
  }
  static kernel::WarpedSample<Batch> SampleAt(const Samples& samples, int at) {
    const Batch value = Batch::load_aligned(samples.value + at);
    return {{value, Batch::load_aligned(samples.du + at), Batch::load_aligned(samples.dv + at)},
            value == value};
  }

  struct Span {
    int begin, end, y;
  };

  // By central differences; a pixel at the border of the image keeps the gradient that it has.
  [[gnu::noinline]] void MixGradients(const Span& pixels, Samples* samples) const {
    if (pixels.y == 0 || pixels.y + 1 == view_.height) return;
    const float share = view_.reference_gradient;
    const float* row = view_.reference_intensity + pixels.y * view_.width;
    for (int x = pixels.begin; x < pixels.end; ++x) {
      if (x == 0 || x + 1 >= view_.width) continue;
      const int at = x - pixels.begin;
      const float du = view_.gain * 0.5f * (row[x + 1] - row[x - 1]);
      const float dv = view_.gain * 0.5f * (row[x + view_.width] - row[x - view_.width]);
      samples->du[at] += share * (du - samples->du[at]);
      samples->dv[at] += share * (dv - samples->dv[at]);
    }
  }

  // The columns of a robust norm are √w·J and √w·r.
  template <Residuals kKind>
  [[gnu::flatten, gnu::noinline]] void LinearizeIntensities(const Span& pixels,
                                                            const Landings& landings,
                                                            const Samples& samples, Chunk* to,
                                                            RowSums* row) const {
    const float* intensity = view_.reference_intensity + pixels.y * view_.width;
    for (int x = pixels.begin, at = 0; x < pixels.end; x += kBatch, at += kBatch) {
      kernel::LinearizedResidual<Batch> r =
          kernel::LinearizeIntensity(warp_, WarpedAt(landings, at), SampleAt(samples, at),
                                     exposed_(Load(intensity, x, view_.width)));
      const int lane = at % kLanes;
      Add(r.residual * r.residual, row->value[kSquaresSum] + lane);
      Add(Ones(r.valid), row->value[kCountSum] + lane);
      if constexpr (kKind != Residuals::kSquares) {
        Add(kernel::Weigh(intensity_norm_, &r), row->value[kRobustSum] + lane);
      }
      Store(r, at, to);
    }
  }

  [[gnu::flatten, gnu::noinline]] void AddBrightness(const Span& pixels, const Samples& samples,
                                                     RowSums* row) const {
    const float* intensity = view_.reference_intensity + pixels.y * view_.width;
    for (int x = pixels.begin, at = 0; x < pixels.end; x += kBatch, at += kBatch) {
      const auto terms = kernel::TermsOf(intensity_norm_, SampleAt(samples, at),
                                         Load(intensity, x, view_.width), exposed_);
      for (int k = 0; k < kBrightnessSumCount; ++k) {
        Add(terms.value[k], row->value[kBrightnessSum + k] + at % kLanes);
      }
    }
  }

  [[gnu::flatten, gnu::noinline]] void LinearizeDepths(int pixels, const Landings& landings,
                                                       const Samples& samples, Chunk* to,
                                                       RowSums* row) const {
    for (int at = 0; at < pixels; at += kBatch) {
      kernel::LinearizedResidual<Batch> d =
          kernel::LinearizeInverseDepth(warp_, WarpedAt(landings, at), SampleAt(samples, at));
      const int lane = at % kLanes;
      Add(Ones(d.valid), row->value[kDepthCountSum] + lane);
      Add(kernel::Weigh(inverse_depth_norm_, &d), row->value[kDepthRobustSum] + lane);
      Store(d, at, to);
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

  template <typename Sampler>
  [[gnu::flatten]] void AddCostOfRow(const Sampler& sampler, int y, RowSums* row) const {
    for (int x = 0; x < padded_width_; x += kBatch) {
      kernel::Mask<Batch> valid;
      const Batch residual = kernel::Residual(warp_, sampler, Pixels(x, y), &valid);
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
  const CubicBatchSampler<Arch> cubic_intensity_;
  const kernel::RobustNorm<Batch> intensity_norm_, inverse_depth_norm_;
  const kernel::Exposed<Batch> exposed_;
  const Batch columns_;  // 0, 1, 2, …
  const int padded_width_;
};

}  // namespace silt::tracker::simd
