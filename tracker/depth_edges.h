// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"

namespace silt::tracker {

// The depths, in metres, without those of pixels nearer than `margin_px` to a jump between two
// surfaces or to a hole, which become 0: their intensities mix both sides. 0: all stay.
Image<float> WithoutDepthEdges(const Image<float>& depth_m, int margin_px);

}  // namespace silt::tracker
