// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/relocalization.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "silt/core/color.h"

namespace silt::tracker {
namespace {

constexpr int kLongerSide = 16;

// Some of a large block's pixels do.
template <typename Gray>
float BlockMean(const Gray& gray, int x, int y, int block) {
  const int stride = std::max(1, block / 8);
  double sum = 0, count = 0;
  for (int j = y; j < y + block; j += stride) {
    for (int i = x; i < x + block; i += stride, ++count) sum += double(gray(i, j));
  }
  return float(sum / count);
}

double Correlation(const Image<float>& a, const Image<float>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return -2;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a.data()[i]) * double(b.data()[i]);
  return sum;
}

template <typename Gray>
Image<float> ThumbnailOf(const Gray& gray, int width, int height) {
  const int block = std::max(1, std::max(width, height) / kLongerSide);
  Image<float> small(width / block, height / block);
  double mean = 0, squares = 0;
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      small(x, y) = BlockMean(gray, x * block, y * block, block);
      mean += double(small(x, y)) / double(small.size());
    }
  }
  for (float& value : small) {
    value -= float(mean);
    squares += double(value) * double(value);
  }
  const float scale = squares > 1e-8 ? float(1 / std::sqrt(squares)) : 0.0f;
  for (float& value : small) value *= scale;
  return small;
}

}  // namespace

Image<float> Thumbnail(const Image<float>& intensity) {
  return ThumbnailOf(intensity, intensity.width(), intensity.height());
}

Image<float> Thumbnail(const Image<Rgb8>& rgb) {
  const auto gray = [&](int x, int y) {
    const Rgb8& c = rgb(x, y);
    return Luma(float(c.r), float(c.g), float(c.b)) / 255.0f;
  };
  return ThumbnailOf(gray, rgb.width(), rgb.height());
}

std::vector<int> MostAlike(const std::vector<const Image<float>*>& thumbnails,
                           const Image<float>& current, int count) {
  std::vector<std::pair<double, int>> by_likeness;
  for (int i = 0; i < int(thumbnails.size()); ++i) {
    by_likeness.emplace_back(-Correlation(*thumbnails[i], current), i);
  }
  const std::size_t kept = std::min<std::size_t>(std::max(count, 0), by_likeness.size());
  std::partial_sort(by_likeness.begin(), by_likeness.begin() + kept, by_likeness.end());
  std::vector<int> indices;
  for (std::size_t i = 0; i < kept; ++i) indices.push_back(by_likeness[i].second);
  return indices;
}

}  // namespace silt::tracker
