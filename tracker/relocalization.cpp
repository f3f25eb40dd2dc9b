// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/relocalization.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace silt::tracker {
namespace {

constexpr int kLongerSide = 16;

float BlockMean(const Image<float>& image, int x, int y, int block) {
  double sum = 0;
  for (int j = y; j < y + block; ++j) {
    for (int i = x; i < x + block; ++i) sum += double(image(i, j));
  }
  return float(sum / (double(block) * block));
}

double Correlation(const Image<float>& a, const Image<float>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return -2;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a.data()[i]) * double(b.data()[i]);
  return sum;
}

}  // namespace

Image<float> Thumbnail(const Image<float>& intensity) {
  const int block = std::max(1, std::max(intensity.width(), intensity.height()) / kLongerSide);
  Image<float> small(intensity.width() / block, intensity.height() / block);
  double mean = 0, squares = 0;
  for (int y = 0; y < small.height(); ++y) {
    for (int x = 0; x < small.width(); ++x) {
      small(x, y) = BlockMean(intensity, x * block, y * block, block);
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
