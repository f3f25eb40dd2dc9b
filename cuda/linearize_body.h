// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"

namespace silt::cuda {

namespace kernel = tracker::kernel;

// What a pass over a level adds up: 21 of JᵀJ, its upper triangle row by row, 6 of Jᵀr, over all
// residuals; then Σr², the number of pixels, and Σs·r² of the robust norm, over those of the
// intensity; then the latter two over those of the inverse depth.
inline constexpr int kSquaresSum = 27, kCountSum = 28, kRobustSum = 29, kDepthCountSum = 30,
                     kDepthRobustSum = 31, kSums = 32;

// Parts of threads are added up in runs of kRun, in double precision, and then run by run.
inline constexpr int kRuns = kThreads / kSums, kRun = kThreads / kRuns;

enum class Residuals { kCost, kSquares, kRobust, kRobustWithDepth };

// The fused pass: warp, residual, Jacobian and normal equations of a level, each thread over every
// place.count()-th pixel, one set of sums per block.
template <Residuals kKind>
struct LinearizeBody {
  static constexpr int kPhases = 3;
  struct Shared {
    float part[kThreads][kSums + 1];  // odd rows: neighbouring threads, different banks
    double run[kRuns][kSums];
  };

  kernel::Warp<float> warp;
  int width, height;
  const float* reference_intensity;
  const float* reference_depth_m;
  kernel::ImageSampler<float> intensity, inverse_depth;  // of the current image
  kernel::RobustNorm<float> intensity_norm, inverse_depth_norm;
  double* block_sums;  // [blocks][kSums]

  SILT_HOST_DEVICE void Run(int phase, const Place& place, Shared& shared) const {
    if (phase == 0) {
      AddPixels(place, shared.part[place.thread]);
    } else if (phase == 1) {
      const int sum = place.thread % kSums, run = place.thread / kSums;
      double total = 0;
      for (int i = 0; i < kRun; ++i) total += double(shared.part[run * kRun + i][sum]);
      shared.run[run][sum] = total;
    } else if (place.thread < kSums) {
      double total = 0;
      for (int run = 0; run < kRuns; ++run) total += shared.run[run][place.thread];
      block_sums[place.block * kSums + place.thread] = total;
    }
  }

 private:
  SILT_HOST_DEVICE void AddPixels(const Place& place, float* part) const {
    float sums[kSums];
    for (float& sum : sums) sum = 0;
    for (int i = place.index(); i < width * height; i += place.count()) AddPixel(i, sums);
    for (int k = 0; k < kSums; ++k) part[k] = sums[k];
  }

  SILT_HOST_DEVICE void AddPixel(int i, float* sums) const {
    const kernel::ReferencePixel<float> pixel{float(i % width), float(i / width),
                                              reference_depth_m[i], reference_intensity[i]};
    const kernel::WarpedPixel<float> warped = kernel::WarpPixel(warp, pixel);
    kernel::LinearizedResidual<float> r =
        kernel::LinearizeIntensity(warp, warped, intensity, pixel.intensity);
    sums[kSquaresSum] += r.residual * r.residual;
    sums[kCountSum] += r.valid ? 1.0f : 0.0f;
    if constexpr (kKind == Residuals::kCost) return;
    if constexpr (kKind == Residuals::kRobust || kKind == Residuals::kRobustWithDepth) {
      sums[kRobustSum] += kernel::Weigh(intensity_norm, &r);
    }
    AddProducts(r, sums);
    if constexpr (kKind == Residuals::kRobustWithDepth) {
      kernel::LinearizedResidual<float> d =
          kernel::LinearizeInverseDepth(warp, warped, inverse_depth);
      sums[kDepthCountSum] += d.valid ? 1.0f : 0.0f;
      sums[kDepthRobustSum] += kernel::Weigh(inverse_depth_norm, &d);
      AddProducts(d, sums);
    }
  }

  SILT_HOST_DEVICE static void AddProducts(const kernel::LinearizedResidual<float>& r,
                                           float* sums) {
    int k = 0;
    for (int i = 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j, ++k) sums[k] += r.jacobian[i] * r.jacobian[j];
    }
    for (int i = 0; i < 6; ++i, ++k) sums[k] += r.jacobian[i] * r.residual;
  }
};

// The sums of all blocks, by one block: first every kRuns-th in order, then these in order.
struct AddBlocks {
  static constexpr int kPhases = 2;
  struct Shared {
    double run[kRuns][kSums];
  };
  const double* block_sums;
  int blocks;
  double* sums;  // [kSums]

  SILT_HOST_DEVICE void Run(int phase, const Place& place, Shared& shared) const {
    const int sum = place.thread % kSums, run = place.thread / kSums;
    if (phase == 0) {
      double total = 0;
      for (int block = run; block < blocks; block += kRuns)
        total += block_sums[block * kSums + sum];
      shared.run[run][sum] = total;
    } else if (place.thread < kSums) {
      double total = 0;
      for (int i = 0; i < kRuns; ++i) total += shared.run[i][sum];
      sums[sum] = total;
    }
  }
};

}  // namespace silt::cuda
