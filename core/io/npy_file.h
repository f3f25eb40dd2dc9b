// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "silt/core/image.h"
#include "silt/core/vector.h"

// NumPy's array files, which numpy.load reads without further knowledge: float32, little-endian,
// of shape (height, width) or (height, width, channels). Written whole or not at all; throw
// silt::Error naming the file.
namespace silt {

void WriteNpy(const std::filesystem::path& file, const Image<float>& image);
void WriteNpy(const std::filesystem::path& file, const Image<Vec3f>& image);

// What the last of these wrote, of that size; anything else in the file is an error.
Image<Vec3f> ReadNpy(const std::filesystem::path& file, int width, int height);

}  // namespace silt
