// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_content.h"

#include <algorithm>
#include <vector>

#include "silt/core/color.h"
#include "silt/core/pyramid.h"

namespace silt::tracker {
namespace {

constexpr int kEvery = 8;

struct ImageFacts {
  double pixels = 0;
  double measured = 0;          // pixels with a depth
  double inverse_depths = 0;    // their sum, 1/m
  double sum = 0, squares = 0;  // of the intensity
};

// Several sums side by side, which the compiler turns into SIMD: single precision within a row.
void AddRow(const float* intensity, const float* depth_m, int width, ImageFacts* facts) {
  constexpr int kSums = 16;
  float measured[kSums] = {}, inverse_depths[kSums] = {}, sum[kSums] = {}, squares[kSums] = {};
  const auto add = [&](int x, int lane) {
    const float counts = IsMeasured(depth_m[x]) ? 1.0f : 0.0f;
    measured[lane] += counts;
    inverse_depths[lane] += counts / (counts > 0 ? depth_m[x] : 1.0f);
    sum[lane] += intensity[x];
    squares[lane] += intensity[x] * intensity[x];
  };
  int x = 0;
  for (; x + kSums <= width; x += kSums) {
    for (int lane = 0; lane < kSums; ++lane) add(x + lane, lane);
  }
  for (int lane = 0; x < width; ++x, ++lane) add(x, lane);
  facts->pixels += width;
  for (int lane = 0; lane < kSums; ++lane) {
    facts->measured += double(measured[lane]);
    facts->inverse_depths += double(inverse_depths[lane]);
    facts->sum += double(sum[lane]);
    facts->squares += double(squares[lane]);
  }
}

// `intensity_row(y)` gives a row of intensities.
template <typename Rows>
ImageContent ContentOfRows(const Rows& intensity_row, const Image<float>& depth_m) {
  if (depth_m.empty()) return {};
  ImageFacts facts;
  for (int y = 0; y < depth_m.height(); y += kEvery) {
    AddRow(intensity_row(y), depth_m.row(y), depth_m.width(), &facts);
  }
  const double mean = facts.sum / facts.pixels;
  return {facts.measured / facts.pixels, std::max(0.0, facts.squares / facts.pixels - mean * mean),
          facts.measured > 0 ? facts.inverse_depths / facts.measured : 0};
}

}  // namespace

ImageContent ContentOf(const Image<Rgb8>& rgb, const Image<float>& depth_m) {
  std::vector<float> gray(std::size_t(rgb.width()));
  const auto row = [&](int y) {
    GrayRow(rgb.row(y), rgb.width(), gray.data());
    return gray.data();
  };
  return ContentOfRows(row, depth_m);
}

ImageContent ContentOf(const Image<float>& intensity, const Image<float>& depth_m) {
  return ContentOfRows([&](int y) { return intensity.row(y); }, depth_m);
}

}  // namespace silt::tracker
