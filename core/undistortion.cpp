// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/undistortion.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt {
namespace {

// Depths that differ by more than this factor belong to different surfaces.
constexpr float kOneSurface = 1.05f;

// The four pixels about a place, and the weights of bilinear interpolation between them.
struct Taps {
  std::size_t index[4];
  float weight[4];

  Taps(const Vec2f& place, int width, int height) {
    const int x = std::min(int(place.x), std::max(width - 2, 0));
    const int y = std::min(int(place.y), std::max(height - 2, 0));
    const float fx = place.x - float(x), fy = place.y - float(y);
    for (int i = 0; i < 4; ++i) {
      const int column = std::min(x + i % 2, width - 1), row = std::min(y + i / 2, height - 1);
      index[i] = std::size_t(row) * std::size_t(width) + std::size_t(column);
      weight[i] = (i % 2 == 1 ? fx : 1 - fx) * (i / 2 == 1 ? fy : 1 - fy);
    }
  }
};

Rgb8 ColourAt(const Image<Rgb8>& rgb, const Taps& taps) {
  float r = 0.5f, g = 0.5f, b = 0.5f;
  for (int i = 0; i < 4; ++i) {
    const Rgb8& tap = rgb.data()[taps.index[i]];
    r += taps.weight[i] * float(tap.r);
    g += taps.weight[i] * float(tap.g);
    b += taps.weight[i] * float(tap.b);
  }
  return {std::uint8_t(r), std::uint8_t(g), std::uint8_t(b)};
}

float DepthAt(const Image<float>& depth_m, const Taps& taps) {
  float sum = 0, low = INFINITY, high = 0;
  int nearest = 0;
  for (int i = 0; i < 4; ++i) {
    const float z = depth_m.data()[taps.index[i]];
    sum += taps.weight[i] * z;
    low = std::min(low, z > 0 ? z : 0);
    high = std::max(high, z);
    if (taps.weight[i] > taps.weight[nearest]) nearest = i;
  }
  const bool one_surface = low > 0 && high <= kOneSurface * low;
  return one_surface ? sum : depth_m.data()[taps.index[nearest]];
}

}  // namespace

Undistortion::Undistortion(const PinholeCamera& camera, const LensDistortion& lens)
    : sources_(camera.width, camera.height) {
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Vec2d seen = ProjectThroughLens(camera, lens, camera.Unproject(x, y, 1.0));
      sources_(x, y) = {float(seen.x), float(seen.y)};
    }
  }
}

Frame Undistortion::Apply(const Frame& frame) const {
  const int width = sources_.width(), height = sources_.height();
  const auto fits = [&](const auto& image) {
    return image.empty() || (image.width() == width && image.height() == height);
  };
  if (!fits(frame.rgb) || !fits(frame.depth_m)) {
    throw Error("undistortion: a picture's size differs from the camera's");
  }
  Frame out{frame.time_s, Image<Rgb8>(frame.rgb.width(), frame.rgb.height()),
            Image<float>(frame.depth_m.width(), frame.depth_m.height())};
  ParallelFor(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const Vec2f& source = sources_(x, y);
      const bool seen = source.x >= 0 && source.y >= 0 && source.x <= float(width - 1) &&
                        source.y <= float(height - 1);
      if (!seen) continue;
      const Taps taps(source, width, height);
      if (!frame.rgb.empty()) out.rgb(x, y) = ColourAt(frame.rgb, taps);
      if (!frame.depth_m.empty()) out.depth_m(x, y) = DepthAt(frame.depth_m, taps);
    }
  });
  return out;
}

}  // namespace silt
