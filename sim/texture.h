// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// One texel: sRGB-encoded colour and opacity, 8 bits each.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba8&) const = default;
};

// A picture that repeats in both directions, with its mip levels. u runs right and v runs up; [0,
// 1]² is the whole picture, whose lower left corner is (0, 0). Levels are kept as 8-bit sRGB,
// filtered in linear light with a box of exactly the texel's area (also for odd sizes).
class Texture {
 public:
  // Not empty. Texels of zero opacity take their colour from their opaque surroundings, so that
  // cut-outs do not fade into an invisible background at their edges.
  explicit Texture(Image<Rgba8> picture);

  int width() const { return levels_.front().width(); }
  int height() const { return levels_.front().height(); }
  int level_count() const { return int(levels_.size()); }
  const Image<Rgba8>& level(int i) const { return levels_[std::size_t(i)]; }

  // Linear colour in [0, 1], trilinear. `lod` is log2 of the footprint's width in texels of level
  // 0: 0 and less read the picture itself, more than the last level reads the mean. Non-finite
  // coordinates read the corner.
  Vec3f Sample(float u, float v, float lod) const;

  // Opacity in [0, 1], bilinear on level 0.
  float Alpha(float u, float v) const;

 private:
  std::vector<Image<Rgba8>> levels_;
};

}  // namespace silt::sim
