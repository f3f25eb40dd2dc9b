// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "silt/sim/camera_rays.h"

namespace silt::sim {

// A part of an image, pixels [left, right) × [top, bottom).
struct ImageTile {
  static constexpr int kSide = 16;  // at most

  int left, top, right, bottom;
};

// Calls body once for each tile of an image, in parallel, denormal numbers flushed to zero. Tiles
// start at multiples of kSide; the last ones may be smaller.
void ForEachTile(int width, int height, const std::function<void(const ImageTile&)>& body);

// For tests that a picture does not depend on the order of its tiles: while one of these lives,
// ForEachTile begins with tile order(0, count), goes on with order(1, count) and so on; order must
// be a permutation for each count. One at a time, made and destroyed where nothing is rendered.
class ScopedTileOrder {
 public:
  explicit ScopedTileOrder(std::function<int(int turn, int count)> order);
  ~ScopedTileOrder();
  ScopedTileOrder(const ScopedTileOrder&) = delete;
  ScopedTileOrder& operator=(const ScopedTileOrder&) = delete;
};

// Calls visit(x, y) for the upper left pixel of each packet's block in a tile, row by row.
template <typename Visit>
void ForEachBlock(const ImageTile& tile, const Visit& visit) {
  for (int y = tile.top; y < tile.bottom; y += CameraRays::kBlock) {
    for (int x = tile.left; x < tile.right; x += CameraRays::kBlock) visit(x, y);
  }
}

}  // namespace silt::sim
