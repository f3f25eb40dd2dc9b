// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/cuda/block/block.h"
#include "silt/tracker/sum_layout.h"

namespace silt::cuda {

// How the pixels of an image are dealt out: tiles of kTileRows rows, as the CPU's, each of which is
// cut into `parts` of consecutive pixels; one block takes one part at a time. It depends on the
// size of the image alone, and so does the order in which sums are formed.
struct Tiling {
  int width = 0, height = 0;
  int pixels_per_thread = 1;
  int tiles = 0, parts = 0;  // of a tile

  SILT_HOST_DEVICE int units() const { return tiles * parts; }
  SILT_HOST_DEVICE int part_pixels() const { return pixels_per_thread * kThreads; }

  // The pixels of unit u are [begin, end); thread t takes every kThreads-th from begin + t.
  SILT_HOST_DEVICE int begin(int u) const {
    return (u / parts) * tracker::kTileRows * width + (u % parts) * part_pixels();
  }
  SILT_HOST_DEVICE int end(int u) const {
    const int last_row = (u / parts + 1) * tracker::kTileRows;
    const int tile_end = (last_row < height ? last_row : height) * width;
    const int part_end = begin(u) + part_pixels();
    return part_end < tile_end ? part_end : tile_end;
  }
};

// As many units as a large GPU runs blocks at once, or fewer: a fine level in one go, a coarse one
// with a pixel for each thread.
SILT_HOST_DEVICE inline Tiling TilingOf(int width, int height) {
  constexpr int kUnits = 240;
  Tiling tiling{width, height};
  // No pixel of a smaller image has four pixels around it.
  if (width < 2 || height < 2) return tiling;
  tiling.pixels_per_thread = (width * height + kUnits * kThreads - 1) / (kUnits * kThreads);
  if (tiling.pixels_per_thread < 1) tiling.pixels_per_thread = 1;
  tiling.tiles = (height + tracker::kTileRows - 1) / tracker::kTileRows;
  tiling.parts = (tracker::kTileRows * width + tiling.part_pixels() - 1) / tiling.part_pixels();
  return tiling;
}

}  // namespace silt::cuda
