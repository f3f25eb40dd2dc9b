// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "silt/core/image.h"
#include "silt/sim/float4.h"
#include "silt/sim/huge_pages.h"

namespace silt::sim {

// One texel of a picture file: sRGB-encoded colour and opacity, 8 bits each.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Rgba8&) const = default;
};

// One picture of a texture's pyramid, linear in light: 16 bits a channel, 65535 is 1. It repeats in
// both directions: behind the last column and row the first ones are stored again, so that a
// texel's right and lower neighbours always lie at the same distance in memory.
class MipLevel {
 public:
  struct Texel {
    std::uint16_t r, g, b, a;
  };

  explicit MipLevel(const Image<Rgba8>& picture);

  // Half the size in both directions, rounded down and at least 1. A texel is the mean over exactly
  // its area (also for odd sizes), of colour weighted by opacity, and of opacity.
  MipLevel Halved() const;
  // Gives invisible texels the colour of the coarser level.
  void FillInvisible(const MipLevel& coarse);

  int width() const { return width_; }
  int height() const { return height_; }
  const Texel& at(int x, int y) const { return texels_[Index(x, y)]; }
  // The texel as a picture file would hold it.
  Image<Rgba8> Encoded() const;
  std::string Digest() const;  // of the size and all texels
  std::size_t bytes() const { return texels_.size() * sizeof(Texel); }

  // Where a value between four texels is read.
  struct Place {
    const Texel *upper, *lower;  // the left ones
    float right, down;

    // Colour in [0, 65535]³ and opacity.
    Float4 Bilinear() const {
      const TexelPair above = LoadTexelPair(&upper->r), below = LoadTexelPair(&lower->r);
      return Lerp(Lerp(above.first, above.second, right), Lerp(below.first, below.second, right),
                  down);
    }
    void Prefetch() const {
      __builtin_prefetch(upper);
      __builtin_prefetch(lower);
    }
  };
  // (x, y) is in texels from the centre of the upper left one; x in [−½, width − ½], y likewise.
  // The place is written where it is to stay: a copy would wait for its parts to reach memory.
  void Find(float x, float y, Place& place) const {
    if (x < 0) x += float(width_);
    if (y < 0) y += float(height_);
    // A sum may be rounded up to the width itself.
    const int column = x < float(width_) ? int(x) : width_ - 1;
    const int row = y < float(height_) ? int(y) : height_ - 1;
    const Texel* texel = texels_.data() + Index(column, row);
    place.upper = texel;
    place.lower = texel + width_ + 1;
    place.right = x - float(column);
    place.down = y - float(row);
  }

 private:
  MipLevel(int width, int height);
  std::size_t Index(int x, int y) const {
    return std::size_t(y) * std::size_t(width_ + 1) + std::size_t(x);
  }
  void RepeatFirst();

  int width_, height_;
  HugePageVector<Texel> texels_;  // of (width + 1) × (height + 1)
};

}  // namespace silt::sim
