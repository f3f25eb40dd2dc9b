// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/image_tiles.h"

#include <algorithm>

#include "silt/core/parallel.h"
#include "silt/sim/denormals.h"

namespace silt::sim {

void ForEachTile(int width, int height, const std::function<void(const ImageTile&)>& body) {
  constexpr int kSide = ImageTile::kSide;
  const int columns = (width + kSide - 1) / kSide, rows = (height + kSide - 1) / kSide;
  ParallelFor(columns * rows, [&](int i) {
    const ScopedFlushDenormals flush;
    const int left = i % columns * kSide, top = i / columns * kSide;
    body({left, top, std::min(left + kSide, width), std::min(top + kSide, height)});
  });
}

}  // namespace silt::sim
