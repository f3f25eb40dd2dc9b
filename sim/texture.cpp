// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

std::array<float, 256> LinearFromByteTable() {
  std::array<float, 256> table;
  for (int i = 0; i < 256; ++i) table[std::size_t(i)] = LinearFromSrgb(float(i) / 255.0f);
  return table;
}

const std::array<float, 256> kLinearFromByte = LinearFromByteTable();

// Entry i lies half-way, in the encoding, between byte i and the next one.
std::array<float, 255> ByteLimitTable() {
  std::array<float, 255> table;
  for (int i = 0; i < 255; ++i) table[std::size_t(i)] = LinearFromSrgb((float(i) + 0.5f) / 255.0f);
  return table;
}

const std::array<float, 255> kByteLimit = ByteLimitTable();

// The nearest sRGB-encoded byte.
std::uint8_t ByteFromLinear(float linear) {
  const auto* const limit = std::upper_bound(kByteLimit.begin(), kByteLimit.end(), linear);
  return std::uint8_t(limit - kByteLimit.begin());
}

std::uint8_t ByteFromUnit(float value) {
  return std::uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

Vec3f Linear(const Rgba8& texel) {
  return {kLinearFromByte[texel.r], kLinearFromByte[texel.g], kLinearFromByte[texel.b]};
}

Vec3f Lerp(const Vec3f& a, const Vec3f& b, float t) { return a + t * (b - a); }

// The source texels under one texel of the next level, along one axis: `size` texels become
// max(1, size/2), each covering size/max(1, size/2) of them, fractions at its ends included.
struct Span {
  int first = 0, last = 0;
  float first_weight = 1, last_weight = 1;

  Span(int index, int size) {
    const int halved = std::max(1, size / 2);
    const double width = double(size) / halved;
    const double begin = index * width, end = begin + width;
    first = int(begin);
    last = std::min(size, int(std::ceil(end - 1e-9))) - 1;
    first_weight = float(first + 1 - begin);
    last_weight = float(end - last);
  }
  float Weight(int i) const { return i == first ? first_weight : i == last ? last_weight : 1.0f; }
};

// Mean over the spans, of colour weighted by opacity and of opacity.
Rgba8 BoxMean(const Image<Rgba8>& fine, const Span& columns, const Span& rows) {
  Vec3f colour;
  float opacity = 0, area = 0;
  for (int y = rows.first; y <= rows.last; ++y) {
    const Rgba8* row = fine.row(y);
    for (int x = columns.first; x <= columns.last; ++x) {
      const float weight = columns.Weight(x) * rows.Weight(y);
      const float visible = weight * float(row[x].a);
      colour += visible * Linear(row[x]);
      opacity += visible;
      area += weight;
    }
  }
  if (opacity > 0) colour = (1.0f / opacity) * colour;
  return {ByteFromLinear(colour.x), ByteFromLinear(colour.y), ByteFromLinear(colour.z),
          ByteFromUnit(opacity / (255.0f * area))};
}

Image<Rgba8> Halved(const Image<Rgba8>& fine) {
  Image<Rgba8> coarse(std::max(1, fine.width() / 2), std::max(1, fine.height() / 2));
  for (int y = 0; y < coarse.height(); ++y) {
    const Span rows(y, fine.height());
    for (int x = 0; x < coarse.width(); ++x) {
      coarse(x, y) = BoxMean(fine, Span(x, fine.width()), rows);
    }
  }
  return coarse;
}

// Gives invisible texels the colour of the coarser level.
void FillInvisible(Image<Rgba8>& fine, const Image<Rgba8>& coarse) {
  for (int y = 0; y < fine.height(); ++y) {
    const int coarse_y = std::min(y / 2, coarse.height() - 1);
    for (int x = 0; x < fine.width(); ++x) {
      if (fine(x, y).a != 0) continue;
      const Rgba8& from = coarse(std::min(x / 2, coarse.width() - 1), coarse_y);
      fine(x, y) = {from.r, from.g, from.b, 0};
    }
  }
}

// The four texels around (u, v) and the weights of the right and the lower ones.
struct Footprint {
  int left, right, above, below;
  float x, y;

  Footprint(const Image<Rgba8>& level, float u, float v) {
    x = Position(u, level.width(), left, right);
    y = Position(-v, level.height(), above, below);
  }

 private:
  // Wraps a coordinate, finds the texel centres (at ½, 1½, …) around it, returns the fraction.
  static float Position(float unit, int size, int& before, int& after) {
    unit -= std::floor(unit);
    if (!(unit <= 1.0f)) unit = 0;
    const float texel = unit * float(size) - 0.5f;
    const float lower = std::floor(texel);
    before = int(lower);
    after = before + 1 == size ? 0 : before + 1;
    if (before < 0) before = size - 1;
    return texel - lower;
  }
};

Vec3f Bilinear(const Image<Rgba8>& level, float u, float v) {
  const Footprint at(level, u, v);
  const Rgba8* above = level.row(at.above);
  const Rgba8* below = level.row(at.below);
  return Lerp(Lerp(Linear(above[at.left]), Linear(above[at.right]), at.x),
              Lerp(Linear(below[at.left]), Linear(below[at.right]), at.x), at.y);
}

}  // namespace

Texture::Texture(Image<Rgba8> picture) {
  SILT_CHECK(!picture.empty());
  levels_.push_back(std::move(picture));
  while (levels_.back().width() > 1 || levels_.back().height() > 1) {
    levels_.push_back(Halved(levels_.back()));
  }
  for (std::size_t i = levels_.size() - 1; i > 0; --i) FillInvisible(levels_[i - 1], levels_[i]);
}

Vec3f Texture::Sample(float u, float v, float lod) const {
  if (!(lod > 0)) return Bilinear(levels_.front(), u, v);
  if (lod >= float(levels_.size() - 1)) return Bilinear(levels_.back(), u, v);
  const auto fine = std::size_t(lod);
  return Lerp(Bilinear(levels_[fine], u, v), Bilinear(levels_[fine + 1], u, v), lod - float(fine));
}

float Texture::Alpha(float u, float v) const {
  const Image<Rgba8>& picture = levels_.front();
  const Footprint at(picture, u, v);
  const Rgba8* above = picture.row(at.above);
  const Rgba8* below = picture.row(at.below);
  const float upper =
      float(above[at.left].a) + at.x * float(int(above[at.right].a) - int(above[at.left].a));
  const float lower =
      float(below[at.left].a) + at.x * float(int(below[at.right].a) - int(below[at.left].a));
  return (upper + at.y * (lower - upper)) / 255.0f;
}

}  // namespace silt::sim
