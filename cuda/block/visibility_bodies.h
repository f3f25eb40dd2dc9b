// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/block.h"
#include "silt/tracker/kernel/visibility.h"

// Bodies that take hidden pixels from a keyframe's depth, for ForEach.
namespace silt::cuda {

namespace kernel = tracker::kernel;

SILT_HOST_DEVICE inline kernel::WarpedPixel<float> WarpDepth(const kernel::Warp<float>& warp,
                                                             const float* depth_m, int width,
                                                             int i) {
  return kernel::WarpPixel<float>(warp, {float(i % width), float(i / width), depth_m[i], 0.0f});
}

// By what the current depth shows.
struct HideBehindCurrent {
  kernel::Warp<float> warp;
  const float* depth_m;
  const float* current_depth_m;
  int width, height;
  float* visible_m;

  SILT_HOST_DEVICE void operator()(int i) const {
    const kernel::WarpedPixel<float> warped = WarpDepth(warp, depth_m, width, i);
    const kernel::LandingPixel<float> landing = kernel::Land(warped, width, height);
    const float seen_m = current_depth_m[int(landing.y) * width + int(landing.x)];
    visible_m[i] = kernel::IsHidden(warped, landing, seen_m) ? 0 : depth_m[i];
  }
};

// By what the keyframe itself shows (tracker/visibility.h), in four steps over cells of the current
// image: empty them; put every point into its own; let each take the least of its neighbourhood;
// compare.
struct EmptyCells {
  float* nearest_m;

  SILT_HOST_DEVICE void operator()(int i) const { nearest_m[i] = 3e38f; }
};

struct FillCells {
  kernel::Warp<float> warp;
  const float* depth_m;
  int width, height;
  float* nearest_m;

  SILT_HOST_DEVICE void operator()(int i) const {
    const kernel::CellLanding landing =
        kernel::LandInCell(WarpDepth(warp, depth_m, width, i), width, height);
    if (landing.z > 0) AtomicMin(nearest_m + landing.cell, landing.z);
  }
};

struct SpreadCells {
  const float* nearest_m;
  kernel::CellGrid cells;
  float* spread_m;

  SILT_HOST_DEVICE void operator()(int i) const {
    const int column = i % cells.columns, row = i / cells.columns;
    float least = nearest_m[i];
    for (int y = row > 0 ? row - 1 : 0; y <= row + 1 && y < cells.rows; ++y) {
      for (int x = column > 0 ? column - 1 : 0; x <= column + 1 && x < cells.columns; ++x) {
        const float z = nearest_m[y * cells.columns + x];
        if (z < least) least = z;
      }
    }
    spread_m[i] = least;
  }
};

struct HideBehindCells {
  kernel::Warp<float> warp;
  const float* depth_m;
  const float* nearest_m;
  int width, height;
  float* visible_m;

  SILT_HOST_DEVICE void operator()(int i) const {
    const kernel::CellLanding landing =
        kernel::LandInCell(WarpDepth(warp, depth_m, width, i), width, height);
    visible_m[i] = kernel::IsHidden(landing, nearest_m[landing.cell]) ? 0 : depth_m[i];
  }
};

}  // namespace silt::cuda
