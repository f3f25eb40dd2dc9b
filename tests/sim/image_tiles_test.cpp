// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/image_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "silt/core/image.h"

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

}  // namespace
}  // namespace silt::sim
