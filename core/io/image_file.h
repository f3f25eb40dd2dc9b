// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "silt/core/image.h"

// Image files, through OpenCV. All throw silt::Error naming the file.
namespace silt {

// TUM's scale: 16-bit PNG depth of 5000 per metre, z along the optical axis; 0 is no measurement.
inline constexpr double kTumDepthPerMetre = 5000;

// Any 8- or 16-bit gray or colour file that OpenCV decodes, as 8-bit RGB: of 16 bits the upper
// eight stay; alpha is dropped.
Image<Rgb8> ReadRgb(const std::filesystem::path& file);

// A 16-bit single-channel file, in metres.
Image<float> ReadDepth(const std::filesystem::path& file, double per_metre = kTumDepthPerMetre);

// PNG, written whole or not at all.
void WriteRgb(const std::filesystem::path& file, const Image<Rgb8>& rgb);

// 16-bit PNG, rounded to the nearest step. Depths beyond the range of 16 bits (13.1 m at 5000 per
// metre), like missing ones, become 0.
void WriteDepth(const std::filesystem::path& file, const Image<float>& depth_m,
                double per_metre = kTumDepthPerMetre);

// PNG of one channel of 8 or 16 bits, and back exactly.
void WriteGray(const std::filesystem::path& file, const Image<std::uint8_t>& gray);
void WriteGray(const std::filesystem::path& file, const Image<std::uint16_t>& gray);
Image<std::uint8_t> ReadGray8(const std::filesystem::path& file);
Image<std::uint16_t> ReadGray16(const std::filesystem::path& file);

}  // namespace silt
