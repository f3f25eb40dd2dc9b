// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "silt/core/color.h"
#include "silt/core/depth_jump.h"
#include "silt/core/pyramid_block.h"
#include "silt/cuda/block/block.h"
#include "silt/tracker/levenberg_marquardt.h"

// Bodies that make pyramids (core/pyramid.h, tracker/depth_edges.h), for ForEach over the pixels
// that they write. Images lie row by row without padding.
namespace silt::cuda {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// GrayFromRgb of core/color.h, bit by bit.
struct ConvertToGray {
  const Rgb8* rgb;
  float* gray;

  SILT_HOST_DEVICE void operator()(int i) const {
    gray[i] = Luma(float(rgb[i].r), float(rgb[i].g), float(rgb[i].b)) / 255.0f;
  }
};

struct HalveIntensity {
  const float* fine;
  int fine_width;
  float* half;
  int width;  // of half

  SILT_HOST_DEVICE void operator()(int i) const {
    const float* upper = fine + 2 * (i / width) * fine_width + 2 * (i % width);
    const float* lower = upper + fine_width;
    half[i] = MeanOfBlock(upper[0], upper[1], lower[0], lower[1]);
  }
};

struct HalveDepth {
  const float* fine_m;
  int fine_width;
  float* half_m;
  int width;

  SILT_HOST_DEVICE void operator()(int i) const {
    const float* upper = fine_m + 2 * (i / width) * fine_width + 2 * (i % width);
    const float* lower = upper + fine_width;
    half_m[i] = NearestSurface({upper[0], upper[1], lower[0], lower[1]});
  }
};

// Where a depth and one of its four neighbours lie on different surfaces.
struct MarkEdges {
  const float* depth_m;
  int width, height;
  unsigned char* edge;

  SILT_HOST_DEVICE void operator()(int i) const {
    const int x = i % width, y = i / width;
    const float z = depth_m[i];
    edge[i] = (x > 0 && IsDepthJump(depth_m[i - 1], z)) ||
              (x + 1 < width && IsDepthJump(z, depth_m[i + 1])) ||
              (y > 0 && IsDepthJump(depth_m[i - width], z)) ||
              (y + 1 < height && IsDepthJump(z, depth_m[i + width]));
  }
};

// The depths that have no edge within `reach` rows and columns; the others become 0.
struct ClearEdges {
  const float* depth_m;
  const unsigned char* edge;
  int width, height, reach;
  float* kept_m;

  SILT_HOST_DEVICE void operator()(int i) const {
    const int x = i % width, y = i / width;
    const int left = x > reach ? x - reach : 0, right = x + reach < width ? x + reach : width - 1;
    const int top = y > reach ? y - reach : 0, bottom = y + reach < height ? y + reach : height - 1;
    bool beside = false;
    for (int row = top; row <= bottom; ++row) {
      for (int column = left; column <= right; ++column) {
        beside = beside || edge[row * width + column] != 0;
      }
    }
    kept_m[i] = beside ? 0 : depth_m[i];
  }
};

// NaN where an edge has taken the depth, so that nothing is compared with it.
struct ClearIntensity {
  const float* depth_m;
  const float* kept_m;
  const float* intensity;
  float* kept;

  SILT_HOST_DEVICE void operator()(int i) const {
    const bool edge = kept_m[i] == 0 && depth_m[i] != 0;
    kept[i] = edge ? kNaN : intensity[i];
  }
};

// 1/Z, NaN where nothing is measured.
struct InvertDepth {
  const float* depth_m;
  float* inverse;

  SILT_HOST_DEVICE void operator()(int i) const {
    const float z = depth_m[i];
    inverse[i] = IsMeasured(z) ? 1 / z : kNaN;
  }
};

// The depths of a pyramid, whose levels follow each other in the blocks that count them.
struct DepthLevels {
  int count = 0;
  const float* depth_m[tracker::kMaxPyramidLevels];
  int size[tracker::kMaxPyramidLevels];
  int first_block[tracker::kMaxPyramidLevels + 1];  // of the level, and after the last one

  SILT_HOST_DEVICE int LevelOf(int block) const {
    int level = 0;
    while (block >= first_block[level + 1]) ++level;
    return level;
  }
};

// The number of measured depths in each block's share of its level.
struct CountMeasured {
  static constexpr int kPhases = 2;
  struct Shared {
    int count[kThreads];
  };
  DepthLevels levels;
  int* block_counts;

  SILT_HOST_DEVICE void Run(int phase, const Place& place, Shared& shared) const {
    if (phase == 0) {
      shared.count[place.thread] = CountOf(place);
    } else if (place.thread == 0) {
      int count = 0;
      for (int i = 0; i < place.grid.threads; ++i) count += shared.count[i];
      block_counts[place.block] = count;
    }
  }

 private:
  SILT_HOST_DEVICE int CountOf(const Place& place) const {
    const int level = levels.LevelOf(place.block), first = levels.first_block[level];
    const int step = (levels.first_block[level + 1] - first) * place.grid.threads;
    int count = 0;
    for (int i = (place.block - first) * place.grid.threads + place.thread; i < levels.size[level];
         i += step) {
      count += IsMeasured(levels.depth_m[level][i]);
    }
    return count;
  }
};

}  // namespace silt::cuda
