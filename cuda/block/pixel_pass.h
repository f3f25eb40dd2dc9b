// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/tiling.h"
#include "silt/cuda/block/visibility_bodies.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"
#include "silt/tracker/pixel_sums.h"

namespace silt::cuda {

namespace kernel = tracker::kernel;

inline constexpr int kSums = tracker::kSumCount;

// Parts of threads are added up in runs of kRun, in double precision, and then run by run.
inline constexpr int kRuns = kThreads / kSums, kRun = kThreads / kRuns;
static_assert(kRuns * kSums == kThreads && kRun * kRuns == kThreads, "each thread has its sum");

enum class Residuals { kCost, kSquares, kRobust, kRobustWithDepth };

SILT_HOST_DEVICE inline Residuals ResidualsOf(const tracker::ResidualNorm& norm) {
  if (norm.use_depth) return Residuals::kRobustWithDepth;
  return norm.robust() ? Residuals::kRobust : Residuals::kSquares;
}

// The fused pass: warp, residual, Jacobian and normal equations of a level's pixels.
struct PixelPass {
  kernel::Warp<float> warp;
  const float* reference_intensity;
  const float* reference_depth_m;
  kernel::ImageSampler<float> intensity, inverse_depth;  // of the current image
  kernel::RobustNorm<float> intensity_norm, inverse_depth_norm;

  // A thread's share of a unit.
  template <Residuals kKind>
  SILT_HOST_DEVICE void AddPixels(const Tiling& tiling, int unit, int thread, float* part) const {
    float sums[kSums];
    SILT_UNROLL for (int k = 0; k < kSums; ++k) sums[k] = 0;
    const int end = tiling.end(unit);
    for (int i = tiling.begin(unit) + thread; i < end; i += kThreads) {
      AddPixel<kKind>(i % tiling.width, i / tiling.width, i, sums);
    }
    SILT_UNROLL for (int k = 0; k < kSums; ++k) part[k] = sums[k];
  }

  SILT_HOST_DEVICE void AddPixels(Residuals kind, const Tiling& tiling, int unit, int thread,
                                  float* part) const {
    switch (kind) {
      case Residuals::kCost:
        return AddPixels<Residuals::kCost>(tiling, unit, thread, part);
      case Residuals::kSquares:
        return AddPixels<Residuals::kSquares>(tiling, unit, thread, part);
      case Residuals::kRobust:
        return AddPixels<Residuals::kRobust>(tiling, unit, thread, part);
      case Residuals::kRobustWithDepth:
        return AddPixels<Residuals::kRobustWithDepth>(tiling, unit, thread, part);
    }
  }

 private:
  template <Residuals kKind>
  SILT_HOST_DEVICE void AddPixel(int x, int y, int i, float (&sums)[kSums]) const {
    const kernel::ReferencePixel<float> pixel{float(x), float(y), reference_depth_m[i],
                                              reference_intensity[i]};
    const kernel::WarpedPixel<float> warped = kernel::WarpPixel(warp, pixel);
    kernel::LinearizedResidual<float> r =
        kernel::LinearizeIntensity(warp, warped, intensity, pixel.intensity);
    sums[tracker::kSquaresSum] += r.residual * r.residual;
    sums[tracker::kCountSum] += r.valid ? 1.0f : 0.0f;
    if constexpr (kKind == Residuals::kCost) return;
    if constexpr (kKind == Residuals::kRobust || kKind == Residuals::kRobustWithDepth) {
      sums[tracker::kRobustSum] += kernel::Weigh(intensity_norm, &r);
    }
    AddProducts(r, sums);
    if constexpr (kKind == Residuals::kRobustWithDepth) {
      kernel::LinearizedResidual<float> d =
          kernel::LinearizeInverseDepth(warp, warped, inverse_depth);
      sums[tracker::kDepthCountSum] += d.valid ? 1.0f : 0.0f;
      sums[tracker::kDepthRobustSum] += kernel::Weigh(inverse_depth_norm, &d);
      AddProducts(d, sums);
    }
  }

  SILT_HOST_DEVICE static void AddProducts(const kernel::LinearizedResidual<float>& r,
                                           float (&sums)[kSums]) {
    int k = 0;
    SILT_UNROLL for (int i = 0; i < 6; ++i) {
      SILT_UNROLL for (int j = i; j < 6; ++j, ++k) sums[k] += r.jacobian[i] * r.jacobian[j];
    }
    SILT_UNROLL for (int i = 0; i < 6; ++i, ++k) sums[k] += r.jacobian[i] * r.residual;
  }
};

// The sums of a unit from the parts of a block's threads, in kPhases phases of which the first
// is to fill the parts.
struct UnitSums {
  static constexpr int kPhases = 3;
  float part[kThreads][kSums + 1];  // odd rows: neighbouring threads, different banks
  double run[kRuns][kSums];

  SILT_HOST_DEVICE void Reduce(int phase, int thread, double* unit_sums) {
    const int sum = thread % kSums;
    double total = 0;
    if (phase == 1) {
      const int first = thread / kSums * kRun;
      for (int i = 0; i < kRun; ++i) total += double(part[first + i][sum]);
      run[thread / kSums][sum] = total;
    } else if (phase == 2 && thread < kSums) {
      for (int i = 0; i < kRuns; ++i) total += run[i][sum];
      unit_sums[sum] = total;
    }
  }
};

// The sums of an image, and Σg·gᵀ over the gradients of its stripes: NormalEquations::scatter.
struct ImageSums {
  static constexpr int kScatter = 21;
  double sums[kSums], scatter[kScatter];
};

SILT_HOST_DEVICE inline tracker::NormalEquations EquationsOf(const ImageSums& image,
                                                             const tracker::ResidualNorm& norm) {
  tracker::NormalEquations equations = tracker::EquationsOf(image.sums, norm);
  for (int k = 0; k < ImageSums::kScatter; ++k) equations.scatter[k] = image.scatter[k];
  return equations;
}

// Makes them of the sums of units, by one block, in kPhases phases: each run takes every kRuns-th
// tile, and then they come in order.
struct TileSums {
  static constexpr int kPhases = 3;
  double run[kRuns][kSums], scatter[kRuns][kSums];

  // `tile_sums` has room for kSums of each tile.
  SILT_HOST_DEVICE void Reduce(int phase, int thread, const Tiling& tiling, const double* unit_sums,
                               double* tile_sums, ImageSums* image) {
    const int sum = thread % kSums, first = thread / kSums;
    if (phase == 0) {
      run[first][sum] = AddTiles(tiling, first, sum, unit_sums, tile_sums);
    } else if (phase == 1) {
      if (sum < ImageSums::kScatter) {
        scatter[first][sum] = AddScatter(tiling, first, sum, tile_sums);
      }
    } else if (first < 2) {
      double total = 0;
      for (int i = 0; i < kRuns; ++i) total += first == 0 ? run[i][sum] : scatter[i][sum];
      if (first == 0) image->sums[sum] = total;
      if (first == 1 && sum < ImageSums::kScatter) image->scatter[sum] = total;
    }
  }

 private:
  SILT_HOST_DEVICE static double AddTiles(const Tiling& tiling, int first, int sum,
                                          const double* unit_sums, double* tile_sums) {
    double total = 0;
    for (int tile = first; tile < tiling.tiles; tile += kRuns) {
      double of_tile = 0;
      for (int part = 0; part < tiling.parts; ++part) {
        of_tile += unit_sums[(tile * tiling.parts + part) * kSums + sum];
      }
      tile_sums[tile * kSums + sum] = of_tile;
      total += of_tile;
    }
    return total;
  }

  SILT_HOST_DEVICE static double AddScatter(const Tiling& tiling, int first, int k,
                                            const double* tile_sums) {
    double total = 0;
    const int stripe = tracker::TilesOfStripe(tiling.tiles);
    for (int tile = first * stripe; tile < tiling.tiles; tile += kRuns * stripe) {
      total += tracker::ScatterOf(tile_sums, tiling.tiles, tile, k);
    }
    return total;
  }
};

}  // namespace silt::cuda
