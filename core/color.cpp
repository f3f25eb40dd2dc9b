// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/color.h"

#include <cmath>

namespace silt {

float LinearFromSrgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float SrgbFromLinear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

Image<float> GrayFromRgb(const Image<Rgb8>& rgb) {
  Image<float> gray(rgb.width(), rgb.height());
  const Rgb8* in = rgb.data();
  for (float& value : gray) {
    value = Luma(float(in->r), float(in->g), float(in->b)) / 255.0f;
    ++in;
  }
  return gray;
}

}  // namespace silt
