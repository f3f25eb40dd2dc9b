// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/image_content.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "silt/core/color.h"
#include "silt/core/pyramid.h"

namespace silt::tracker {
namespace {

constexpr int kEvery = 8;

// Of two neighbours with a depth, those of two surfaces: the farther is farther by this share.
constexpr float kJump = 0.1f;
// Windows in which the intensity changes less than this in the mean tell nothing.
constexpr float kLeastChange = 2.0f / 255;
// Jumps with texture about them, fewer of which tell nothing.
constexpr int kLeastJumps = 30;

// What is at a jump and what is beside it, in pixels along a row. A Kinect's depths end up to three
// pixels off the edge at 640 pixels; what has another focal length or stands elsewhere is off by
// more nearly everywhere.
struct JumpWindow {
  explicit JumpWindow(int width)
      : step(std::max(1, width / 640)),
        at(std::max(1, width * 3 / 640)),
        beside(std::max(3, width * 8 / 640)),
        reach(std::max(9, width * 24 / 640)) {}

  int step;  // over which the intensity changes
  int at, beside, reach;
};

struct JumpSums {
  double at = 0, beside = 0;  // changes per mean of their window
  int jumps = 0;
};

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

// Along a row from `first` to `last`, both included.
float SumOfChanges(const float* intensity, int step, int first, int last) {
  float sum = 0;
  for (int x = first; x <= last; ++x) sum += std::abs(intensity[x + step] - intensity[x - step]);
  return sum;
}

void AddJump(const float* intensity, int x, const JumpWindow& window, JumpSums* sums) {
  const auto [step, at, beside, reach] = window;
  const float mean = SumOfChanges(intensity, step, x - reach, x + reach) / float(2 * reach + 1);
  if (!(mean >= kLeastChange)) return;
  const float changes_at = SumOfChanges(intensity, step, x - at, x + at);
  const float changes_beside = SumOfChanges(intensity, step, x - reach, x - beside) +
                               SumOfChanges(intensity, step, x + beside, x + reach);
  sums->at += double(changes_at / (float(2 * at + 1) * mean));
  sums->beside += double(changes_beside / (float(2 * (reach - beside + 1)) * mean));
  ++sums->jumps;
}

bool IsJump(float a, float b) { return std::abs(a - b) > kJump * std::min(a, b); }

// The pixel at which a nearer surface ends, where the one at x and the next one that has a depth
// are of two surfaces; −1 where not. What the nearer one hides from the sensor has none.
int EndOfNearer(const float* depth_m, int width, int x, int reach) {
  if (!IsMeasured(depth_m[x])) return -1;
  for (int next = x + 1; next < width && next <= x + reach; ++next) {
    if (!IsMeasured(depth_m[next])) continue;
    if (!IsJump(depth_m[x], depth_m[next])) return -1;
    return depth_m[x] < depth_m[next] ? x : next;
  }
  return -1;
}

void AddJumps(const float* intensity, const float* depth_m, int width, JumpSums* sums) {
  constexpr int kBlock = 16;
  const JumpWindow window(width);
  const int margin = window.reach + window.step;
  int first = margin;  // from which the next jump counts
  for (int block = 0; block + 1 < width; block += kBlock) {
    const int end = std::min(block + kBlock, width - 1);
    // Where there is neither a jump nor a hole, as nearly everywhere, SIMD finds that out.
    int even = 0;
    for (int x = block; x < end; ++x) {
      const float a = depth_m[x], b = depth_m[x + 1];
      even += std::abs(a - b) <= kJump * (a < b ? a : b) ? 1 : 0;
    }
    if (even == end - block) continue;
    for (int x = block; x < end; ++x) {
      const int edge = EndOfNearer(depth_m, width, x, window.reach);
      if (edge < first || edge + margin >= width) continue;
      AddJump(intensity, edge, window, sums);
      first = edge + window.beside;
    }
  }
}

// `intensity_row(y)` gives a row of intensities.
template <typename Rows>
ImageContent ContentOfRows(const Rows& intensity_row, const Image<float>& depth_m) {
  if (depth_m.empty()) return {};
  ImageFacts facts;
  JumpSums jumps;
  for (int y = 0; y < depth_m.height(); y += kEvery) {
    const float* intensity = intensity_row(y);
    AddRow(intensity, depth_m.row(y), depth_m.width(), &facts);
    AddJumps(intensity, depth_m.row(y), depth_m.width(), &jumps);
  }
  const double mean = facts.sum / facts.pixels;
  return {facts.measured / facts.pixels, std::max(0.0, facts.squares / facts.pixels - mean * mean),
          facts.measured > 0 ? facts.inverse_depths / facts.measured : 0,
          jumps.jumps >= kLeastJumps ? jumps.at / std::max(jumps.beside, 1e-3) : 0};
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
