// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/mip_level.h"

namespace silt::sim {

// A picture that repeats in both directions, with its mip levels. u runs right and v runs up; [0,
// 1]² is the whole picture, whose lower left corner is (0, 0). Levels are kept and filtered in
// linear light.
class Texture {
 public:
  // Not empty. Texels of zero opacity take their colour from their opaque surroundings, so that
  // cut-outs do not fade into an invisible background at their edges.
  explicit Texture(const Image<Rgba8>& picture);

  int width() const { return levels_.front().width(); }
  int height() const { return levels_.front().height(); }
  int level_count() const { return int(levels_.size()); }
  // As a picture file would hold it.
  Image<Rgba8> level(int i) const { return levels_[std::size_t(i)].Encoded(); }
  // Of memory, all levels.
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const MipLevel& level : levels_) sum += level.bytes();
    return sum;
  }
  // Tells pictures apart: 32 hexadecimal digits.
  std::string Digest() const { return levels_.front().Digest(); }

  // Linear colour in [0, 1], trilinear. `lod` is log2 of the footprint's width in texels of level
  // 0: 0 and less read the picture itself, more than the last level reads the mean. Non-finite
  // coordinates read the corner.
  Vec3f Sample(float u, float v, float lod) const {
    Place place;
    Find(u, v, lod, place);
    return Vec3From(place.Read());
  }

  // The same in two steps, so that memory can be asked for in between.
  struct Place {
    MipLevel::Place fine, coarse;
    float blend;  // 0: the fine one alone

    Float4 Read() const {
      constexpr float kUnit = 1.0f / 65535;
      if (blend == 0) return kUnit * fine.Bilinear();
      return kUnit * Lerp(fine.Bilinear(), coarse.Bilinear(), blend);
    }
    void Prefetch() const {
      fine.Prefetch();
      if (blend != 0) coarse.Prefetch();
    }
  };
  void Find(float u, float v, float lod, Place& place) const;

  // Opacity in [0, 1], bilinear on level 0.
  float Alpha(float u, float v) const;

 private:
  // The fraction of a coordinate, in [0, 1]; 0 for one that is too large to have any.
  static float Wrapped(float coordinate) {
    if (!(coordinate > -1e6f && coordinate < 1e6f)) return 0;
    const float fraction = coordinate - float(int(coordinate));
    return fraction < 0 ? fraction + 1 : fraction;
  }
  static void FindIn(const MipLevel& level, float right, float down, MipLevel::Place& place) {
    level.Find(right * float(level.width()) - 0.5f, down * float(level.height()) - 0.5f, place);
  }

  std::vector<MipLevel> levels_;
};

inline void Texture::Find(float u, float v, float lod, Place& place) const {
  const float right = Wrapped(u), down = Wrapped(-v);
  const auto last = float(levels_.size() - 1);
  const float level = lod > 0 ? (lod < last ? lod : last) : 0;
  const auto fine = std::size_t(level);
  place.blend = level - float(fine);
  FindIn(levels_[fine], right, down, place.fine);
  if (place.blend != 0) FindIn(levels_[fine + 1], right, down, place.coarse);
}

}  // namespace silt::sim
