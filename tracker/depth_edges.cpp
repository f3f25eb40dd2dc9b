// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/depth_edges.h"

#include <algorithm>
#include <cstdint>

#include "silt/core/parallel.h"
#include "silt/tracker/kernel/depth_edge.h"

namespace silt::tracker {
namespace {

using Mask = Image<std::uint8_t>;

// Where a depth differs from that of `other`, a row or the same row one pixel on.
void MarkJumps(const float* depth_m, const float* other_m, int n, std::uint8_t* here,
               std::uint8_t* there) {
  for (int x = 0; x < n; ++x) {
    const std::uint8_t jump = kernel::IsDepthJump(depth_m[x], other_m[x]);
    here[x] |= jump;
    there[x] |= jump;
  }
}

// Both pixels of every jump.
Mask Jumps(const Image<float>& depth_m) {
  const int width = depth_m.width(), height = depth_m.height();
  Mask mask(width, height);
  for (int y = 0; y < height; ++y) {
    MarkJumps(depth_m.row(y), depth_m.row(y) + 1, width - 1, mask.row(y), mask.row(y) + 1);
    if (y + 1 < height) {
      MarkJumps(depth_m.row(y), depth_m.row(y + 1), width, mask.row(y), mask.row(y + 1));
    }
  }
  return mask;
}

// Marks the pixels up to `reach` columns beside a marked one.
Mask Widened(const Mask& mask, int reach) {
  Mask wide = mask;
  ParallelFor(mask.height(), [&](int y) {
    for (int step = 1; step <= std::min(reach, mask.width() - 1); ++step) {
      const std::uint8_t* from = mask.row(y);
      std::uint8_t* to = wide.row(y);
      for (int x = step; x < mask.width(); ++x) to[x] |= from[x - step];
      for (int x = 0; x + step < mask.width(); ++x) to[x] |= from[x + step];
    }
  });
  return wide;
}

}  // namespace

Image<float> WithoutDepthEdges(const Image<float>& depth_m, int margin_px) {
  Image<float> kept = depth_m;
  if (margin_px <= 0 || depth_m.empty()) return kept;
  const int reach = margin_px - 1;
  const Mask edges = Widened(Jumps(depth_m), reach);
  ParallelFor(depth_m.height(), [&](int y) {
    const int last = std::min(depth_m.height() - 1, y + reach);
    for (int row = std::max(0, y - reach); row <= last; ++row) {
      const std::uint8_t* edge = edges.row(row);
      float* depth = kept.row(y);
      for (int x = 0; x < depth_m.width(); ++x) depth[x] = edge[x] ? 0 : depth[x];
    }
  });
  return kept;
}

}  // namespace silt::tracker
