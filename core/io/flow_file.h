// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt {

// Optical flow as a .flo file of the Middlebury benchmark, which OpenCV's readOpticalFlow reads:
// the float32 202021.25, int32 width and height, then (u, v) of each pixel, row by row, in pixels.
// More than 1e9 means unknown. Written whole or not at all; throws silt::Error naming the file.
void WriteFlow(const std::filesystem::path& file, const Image<Vec2f>& flow_px);

}  // namespace silt
