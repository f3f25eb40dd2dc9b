// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/core/image.h"
#include "silt/tracker/image_pool.h"
#include "silt/tracker/simd/preparation.h"
#include "silt/tracker/simd_level.h"

namespace silt::tracker {

// Levels are shared between pyramids that differ in some of them.
using CpuLevel = std::shared_ptr<const Image<float>>;
using CpuPyramid = std::vector<CpuLevel>;  // the finest first

// Makes pyramids of images, in tiles of rows on ParallelFor's threads.
class CpuPreparation {
 public:
  explicit CpuPreparation(SimdLevel level);

  // The image itself is level 0, without a copy: see Own.
  CpuPyramid Intensity(const Image<float>& finest, int levels) const;
  CpuPyramid Depth(const Image<float>& finest_m, int levels) const;
  // A copy that outlives the image.
  CpuLevel Own(const Image<float>& image) const;

  // A level's depth and intensity away from the edges of its depth; see depth_edges.h.
  struct Wanted {
    bool depth = false, inverse_depth = false, intensity = false;
  };
  struct Kept {
    CpuLevel depth_m;        // 0 at edges
    CpuLevel inverse_depth;  // NaN at edges and where nothing is measured
    CpuLevel intensity;      // NaN at edges, but not for holes
    int measured = 0;        // of the depths that are kept
  };
  // What is not wanted is null. `intensity` may be null where it is not.
  Kept AwayFromEdges(const Image<float>& depth_m, const Image<float>* intensity, int margin_px,
                     const Wanted& wanted) const;

  // An image of arbitrary values.
  std::shared_ptr<Image<float>> Take(int width, int height) const {
    return pool_->Take(width, height);
  }

 private:
  using Halve = void (*)(const simd::HalvedView& view, int begin, int end);
  CpuPyramid Halved(const Image<float>& finest, int levels, Halve halve) const;

  simd::PreparationKernels kernels_;
  std::shared_ptr<ImagePool> pool_;
};

}  // namespace silt::tracker
