// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/image_tiles.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/denormals.h"

namespace silt::sim {
namespace {

std::function<int(int turn, int count)> test_order;  // empty but within a test

}  // namespace

ScopedTileOrder::ScopedTileOrder(std::function<int(int turn, int count)> order) {
  SILT_CHECK(!test_order);
  test_order = std::move(order);
}

ScopedTileOrder::~ScopedTileOrder() { test_order = nullptr; }

void ForEachTile(int width, int height, const std::function<void(const ImageTile&)>& body) {
  constexpr int kSide = ImageTile::kSide;
  const int columns = (width + kSide - 1) / kSide, rows = (height + kSide - 1) / kSide;
  ParallelFor(columns * rows, [&](int turn) {
    const ScopedFlushDenormals flush;
    const int i = test_order ? test_order(turn, columns * rows) : turn;
    const int left = i % columns * kSide, top = i / columns * kSide;
    body({left, top, std::min(left + kSide, width), std::min(top + kSide, height)});
  });
}

}  // namespace silt::sim
