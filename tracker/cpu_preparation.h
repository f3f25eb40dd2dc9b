// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/memory_pool.h"
#include "silt/core/vector.h"
#include "silt/tracker/image_pool.h"
#include "silt/tracker/simd/preparation.h"
#include "silt/tracker/simd_level.h"

namespace silt::tracker {

// Levels are shared between pyramids that differ in some of them.
using CpuLevel = std::shared_ptr<const Image<float>>;
using CpuPyramid = PooledVector<CpuLevel>;  // the finest first

// Makes pyramids of images, in tiles of rows on ParallelFor's threads.
class CpuPreparation {
 public:
  explicit CpuPreparation(SimdLevel level);

  // A colour image, or else a gray one; the depth may be missing.
  struct Source {
    const Image<Rgb8>* rgb = nullptr;
    const Image<float>* gray = nullptr;
    const Image<float>* depth_m = nullptr;

    int width() const { return rgb ? rgb->width() : gray->width(); }
    int height() const { return rgb ? rgb->height() : gray->height(); }
  };
  struct Pyramids {
    CpuPyramid intensity, depth_m;
  };
  // Level 0 is the source's own image, without a copy: see Own. Of a colour image it is null unless
  // `finest` is 0.
  Pyramids Make(const Source& source, int levels, int finest) const;
  CpuPyramid Depth(const Image<float>& finest_m, int levels) const;
  // A copy that outlives the image.
  CpuLevel Own(const Image<float>& image) const;

  // A level's depth and intensity, and what of them lies away from the edges of its depth; see
  // depth_edges.h.
  struct Level {
    const Image<float>* depth_m = nullptr;
    const Image<float>* intensity = nullptr;  // may be null where it is not wanted
    int margin_px = 0;
  };
  struct Wanted {
    bool depth = false, inverse_depth = false, intensity = false;
  };
  struct Kept {
    CpuLevel depth_m;        // 0 at edges
    CpuLevel inverse_depth;  // NaN at edges and where nothing is measured
    CpuLevel intensity;      // NaN at edges, but not for holes
    int measured = 0;        // of the depths that are kept
  };
  // What is not wanted is null.
  PooledVector<Kept> AwayFromEdges(const PooledVector<Level>& levels, const Wanted& wanted) const;

  // An image of arbitrary values.
  std::shared_ptr<Image<float>> Take(int width, int height) const {
    return pool_->Take(width, height);
  }

 private:
  struct Buffers;
  Buffers BuffersFor(const Source& source, int levels, int finest) const;
  void MakeRows(const Source& source, const Buffers& buffers, int begin, int end) const;

  simd::PreparationKernels kernels_;
  std::shared_ptr<ImagePool> pool_;
};

}  // namespace silt::tracker
