// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// A signal linear in light to 8 bits: clipped to [0, 1], encoded as sRGB, rounded to nearest.
std::uint8_t EncodeSrgb8(float linear);
Image<Rgb8> EncodeSrgb8(const Image<Vec3f>& linear);

}  // namespace silt::sim
