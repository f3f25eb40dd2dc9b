// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt {

// IEC 61966-2-1: 8-bit sRGB is not linear in light. Both work on [0, 1].
float LinearFromSrgb(float encoded);
float SrgbFromLinear(float linear);

// Rec. 601 luma of sRGB-encoded values (the weights of OpenCV's gray images).
template <typename T>
constexpr T Luma(const T& r, const T& g, const T& b) {
  return T(0.299f) * r + T(0.587f) * g + T(0.114f) * b;
}

// Intensity in [0, 1], the scale of the paper's costs.
Image<float> GrayFromRgb(const Image<Rgb8>& rgb);
void GrayRow(const Rgb8* rgb, int width, float* gray);
// Into an image whose memory is used again if it has the size.
void GrayFromRgb(const Image<Rgb8>& rgb, Image<float>* gray);

}  // namespace silt
