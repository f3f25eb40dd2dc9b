// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"

namespace silt::tracker {

// What the cubic B-spline that goes through the pixels of `image` is made of, one for each; the
// image goes on beyond its borders as in a mirror (Unser 1999). All pixels are finite.
Image<float> SplineCoefficients(const Image<float>& image);

}  // namespace silt::tracker
