// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace silt::sim {

struct PictureSize {
  std::uint64_t width = 0, height = 0;
};

// The size that a PNG, JPEG, BMP or TIFF file declares (of its first picture), without decoding it:
// some 100 bytes may declare gigabytes. Nothing for other files and broken ones.
std::optional<PictureSize> DeclaredPictureSize(std::string_view file);

}  // namespace silt::sim
