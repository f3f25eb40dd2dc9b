// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/pixel_pass.h"

// Bodies that compute one level's normal equations, or its cost, at one pose.
namespace silt::cuda {

// One unit per block.
struct LinearizeBody {
  static constexpr int kPhases = UnitSums::kPhases;
  using Shared = UnitSums;

  PixelPass pass;
  Residuals kind;
  Tiling tiling;
  double* unit_sums;  // [units][kSums]

  SILT_HOST_DEVICE void Run(int phase, const Place& place, Shared& shared) const {
    if (phase == 0) {
      pass.AddPixels(kind, tiling, place.block, place.thread, shared.part[place.thread]);
    } else {
      shared.Reduce(phase, place.thread, unit_sums + place.block * kSums);
    }
  }
};

// Then these, by one block.
struct AddUnits {
  static constexpr int kPhases = TileSums::kPhases;
  using Shared = TileSums;

  Tiling tiling;
  const double* unit_sums;
  double* tile_sums;  // [tiles][kSums]
  ImageSums* image;

  SILT_HOST_DEVICE void Run(int phase, const Place& place, Shared& shared) const {
    shared.Reduce(phase, place.thread, tiling, unit_sums, tile_sums, image);
  }
};

}  // namespace silt::cuda
