// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/mip_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "silt/core/color.h"
#include "silt/sim/content_hash.h"

namespace silt::sim {
namespace {

std::array<std::uint16_t, 256> LinearTable() {
  std::array<std::uint16_t, 256> table;
  for (int i = 0; i < 256; ++i) {
    table[std::size_t(i)] = std::uint16_t(std::lround(65535 * LinearFromSrgb(float(i) / 255)));
  }
  return table;
}

// By byte. Distinct: even the darkest bytes lie 20 apart.
const std::array<std::uint16_t, 256> kLinear = LinearTable();

// By linear value, the byte whose encoding is nearest: from the middle between two bytes, which is
// LinearFromSrgb of theirs, upwards the higher one.
std::vector<std::uint8_t> EncodedTable() {
  const auto middle_above = [](int code) {
    return 65535 * LinearFromSrgb((float(code) + 0.5f) / 255);
  };
  std::vector<std::uint8_t> table;
  for (int code = 0; code < 255; ++code) {
    while (float(table.size()) < middle_above(code)) table.push_back(std::uint8_t(code));
  }
  table.resize(65536, 255);
  return table;
}

std::uint8_t EncodedByte(std::uint16_t linear) {
  static const std::vector<std::uint8_t> table = EncodedTable();
  return table[linear];
}

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

std::uint16_t Rounded(float value) {
  return std::uint16_t(std::clamp(value, 0.0f, 65535.0f) + 0.5f);
}

MipLevel::Texel MeanOver(const MipLevel& fine, const Span& columns, const Span& rows) {
  Float4 sum{};
  float area = 0;
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const MipLevel::Texel& t = fine.at(x, y);
      const float weight = columns.Weight(x) * rows.Weight(y), visible = weight * float(t.a);
      sum += visible * Float4{float(t.r), float(t.g), float(t.b), 1};
      area += weight;
    }
  }
  const float opacity = sum[3];
  if (opacity > 0) sum /= opacity;
  return {Rounded(sum[0]), Rounded(sum[1]), Rounded(sum[2]), Rounded(opacity / area)};
}

// The common case in integers: two by two texels, all opaque.
bool MeanOfFour(const MipLevel& fine, int x, int y, MipLevel::Texel& mean) {
  const MipLevel::Texel &a = fine.at(x, y), &b = fine.at(x + 1, y), &c = fine.at(x, y + 1),
                        &d = fine.at(x + 1, y + 1);
  if ((a.a & b.a & c.a & d.a) != 0xffff) return false;
  const auto of = [](unsigned sum) { return std::uint16_t((sum + 2) / 4); };
  mean = {of(a.r + b.r + c.r + d.r), of(a.g + b.g + c.g + d.g), of(a.b + b.b + c.b + d.b), 0xffff};
  return true;
}

}  // namespace

MipLevel::MipLevel(int width, int height)
    : width_(width), height_(height), texels_(std::size_t(width + 1) * std::size_t(height + 1)) {}

MipLevel::MipLevel(const Image<Rgba8>& picture) : MipLevel(picture.width(), picture.height()) {
  for (int y = 0; y < height_; ++y) {
    const Rgba8* in = picture.row(y);
    Texel* out = texels_.data() + Index(0, y);
    for (int x = 0; x < width_; ++x) {
      out[x] = {kLinear[in[x].r], kLinear[in[x].g], kLinear[in[x].b], std::uint16_t(in[x].a * 257)};
    }
  }
  RepeatFirst();
}

void MipLevel::RepeatFirst() {
  for (int y = 0; y < height_; ++y) texels_[Index(width_, y)] = texels_[Index(0, y)];
  std::copy_n(texels_.begin(), width_ + 1, texels_.begin() + std::ptrdiff_t(Index(0, height_)));
}

MipLevel MipLevel::Halved() const {
  MipLevel coarse(std::max(1, width_ / 2), std::max(1, height_ / 2));
  const bool even = width_ % 2 == 0 && height_ % 2 == 0;
  for (int y = 0; y < coarse.height_; ++y) {
    const Span rows(y, height_);
    for (int x = 0; x < coarse.width_; ++x) {
      Texel& mean = coarse.texels_[coarse.Index(x, y)];
      if (even && MeanOfFour(*this, 2 * x, 2 * y, mean)) continue;
      mean = MeanOver(*this, Span(x, width_), rows);
    }
  }
  coarse.RepeatFirst();
  return coarse;
}

void MipLevel::FillInvisible(const MipLevel& coarse) {
  for (int y = 0; y < height_; ++y) {
    const int coarse_y = std::min(y / 2, coarse.height_ - 1);
    for (int x = 0; x < width_; ++x) {
      Texel& texel = texels_[Index(x, y)];
      if (texel.a != 0) continue;
      const Texel& from = coarse.at(std::min(x / 2, coarse.width_ - 1), coarse_y);
      texel = {from.r, from.g, from.b, 0};
    }
  }
  RepeatFirst();
}

std::string MipLevel::Digest() const {
  return ContentHash()
      .Add(width_)
      .AddBytes(texels_.data(), texels_.size() * sizeof(Texel))
      .Digest();
}

Image<Rgba8> MipLevel::Encoded() const {
  Image<Rgba8> picture(width_, height_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Texel& t = at(x, y);
      picture(x, y) = {EncodedByte(t.r), EncodedByte(t.g), EncodedByte(t.b),
                       std::uint8_t((t.a + 128) / 257)};
    }
  }
  return picture;
}

}  // namespace silt::sim
