// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/image_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

TEST(ImageTiles, CoverEveryPixelOnce) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{16, 32}, std::pair{50, 33}}) {
    Image<int> visits(width, height);
    ForEachTile(width, height, [&visits](const ImageTile& tile) {
      EXPECT_EQ(tile.left % 16, 0);
      EXPECT_EQ(tile.top % 16, 0);
      for (int y = tile.top; y < tile.bottom; ++y) {
        for (int x = tile.left; x < tile.right; ++x) ++visits(x, y);
      }
    });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), width * height);
  }
}

TEST(ImageTiles, AnEmptyImageHasNone) {
  ForEachTile(0, 10, [](const ImageTile&) { FAIL(); });
}

TEST(ImageTiles, ATestMayGiveTheirOrder) {
  const auto lefts = [] {
    std::vector<int> order;
    ForEachTile(64, 16, [&order](const ImageTile& tile) { order.push_back(tile.left); });
    return order;
  };
  SetThreadCount(1);
  {
    const ScopedTileOrder reversed([](int turn, int count) { return count - 1 - turn; });
    EXPECT_EQ(lefts(), (std::vector<int>{48, 32, 16, 0}));
  }
  EXPECT_EQ(lefts(), (std::vector<int>{0, 16, 32, 48}));
  SetThreadCount(0);
}

}  // namespace
}  // namespace silt::sim
