// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace silt::sim {

// A part of an image, pixels [left, right) × [top, bottom).
struct ImageTile {
  int left, top, right, bottom;
};

// Calls body once for each tile of an image, in parallel, denormal numbers flushed to zero. Tiles
// start at multiples of 16; the last ones may be smaller.
void ForEachTile(int width, int height, const std::function<void(const ImageTile&)>& body);

}  // namespace silt::sim
