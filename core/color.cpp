// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/color.h"

#include <algorithm>
#include <cmath>

#include "silt/core/parallel.h"

namespace silt {
namespace {

constexpr int kTileRows = 32;

// What each 8-bit value adds to Luma().
struct LumaShares {
  float r[256], g[256], b[256];
};

constexpr LumaShares MakeLumaShares() {
  LumaShares shares{};
  for (int i = 0; i < 256; ++i) {
    const float value = float(i);
    shares.r[i] = Luma(value, 0.0f, 0.0f);
    shares.g[i] = Luma(0.0f, value, 0.0f);
    shares.b[i] = Luma(0.0f, 0.0f, value);
  }
  return shares;
}

constexpr LumaShares kLumaShares = MakeLumaShares();

}  // namespace

// Looking a share up is faster than converting and multiplying; the division runs in SIMD.
void GrayRow(const Rgb8* rgb, int width, float* gray) {
  for (int x = 0; x < width; ++x) {
    gray[x] = kLumaShares.r[rgb[x].r] + kLumaShares.g[rgb[x].g] + kLumaShares.b[rgb[x].b];
  }
  for (int x = 0; x < width; ++x) gray[x] /= 255.0f;
}

float LinearFromSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float SrgbFromLinear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

Image<float> GrayFromRgb(const Image<Rgb8>& rgb) {
  Image<float> gray;
  GrayFromRgb(rgb, &gray);
  return gray;
}

void GrayFromRgb(const Image<Rgb8>& rgb, Image<float>* gray) {
  const int width = rgb.width(), height = rgb.height();
  if (gray->width() != width || gray->height() != height) *gray = Image<float>(width, height);
  ParallelFor((height + kTileRows - 1) / kTileRows, [&](int tile) {
    for (int y = tile * kTileRows; y < std::min(height, (tile + 1) * kTileRows); ++y) {
      GrayRow(rgb.row(y), width, gray->row(y));
    }
  });
}

}  // namespace silt
