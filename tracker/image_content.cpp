// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_content.h"

#include <algorithm>
#include <vector>

#include "silt/core/parallel.h"
#include "silt/core/pyramid.h"

namespace silt::tracker {
namespace {

// What a keyframe's images are like.
struct ImageFacts {
  double measured = 0;          // pixels with a depth
  double inverse_depths = 0;    // their sum, 1/m
  double sum = 0, squares = 0;  // of the intensity

  ImageFacts& operator+=(const ImageFacts& other) {
    measured += other.measured;
    inverse_depths += other.inverse_depths;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
};

// Several sums side by side, so that no addition waits for the one before it.
ImageFacts FactsOfRow(const float* intensity, const float* depth_m, int width) {
  constexpr int kSums = 8;
  ImageFacts sums[kSums], total;
  for (int x = 0; x < width; ++x) {
    ImageFacts& facts = sums[x % kSums];
    const bool measured = IsMeasured(depth_m[x]);
    facts.measured += measured ? 1 : 0;
    facts.inverse_depths += measured ? 1 / double(depth_m[x]) : 0;
    facts.sum += double(intensity[x]);
    facts.squares += double(intensity[x]) * double(intensity[x]);
  }
  for (const ImageFacts& facts : sums) total += facts;
  return total;
}

// Row by row in parallel, then the rows in order.
ImageFacts FactsOf(const Image<float>& intensity, const Image<float>& depth_m) {
  std::vector<ImageFacts> rows(std::size_t(intensity.height()));
  ParallelFor(intensity.height(), [&](int y) {
    rows[std::size_t(y)] = FactsOfRow(intensity.row(y), depth_m.row(y), intensity.width());
  });
  ImageFacts total;
  for (const ImageFacts& row : rows) total += row;
  return total;
}

}  // namespace

ImageContent ContentOf(const Image<float>& intensity, const Image<float>& depth_m) {
  if (depth_m.empty() || intensity.empty()) return {};
  const ImageFacts facts = FactsOf(intensity, depth_m);
  const double pixels = double(intensity.size()), mean = facts.sum / pixels;
  return {facts.measured / pixels, std::max(0.0, facts.squares / pixels - mean * mean),
          facts.measured > 0 ? facts.inverse_depths / facts.measured : 0};
}

}  // namespace silt::tracker
