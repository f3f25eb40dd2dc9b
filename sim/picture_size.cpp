// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/picture_size.h"

#include <cstdlib>

namespace silt::sim {
namespace {

using namespace std::string_view_literals;

std::uint64_t BigEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

std::uint64_t LittleEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

// Follows the segments, FF marker length …, to the start of a frame: precision, height, width.
std::optional<PictureSize> JpegSize(std::string_view file) {
  std::size_t at = 2;
  while (at + 9 <= file.size() && file[at] == '\xff') {
    const auto marker = static_cast<unsigned char>(file[at + 1]);
    if (marker == 0xff) {
      ++at;  // a filler
      continue;
    }
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (is_frame)
      return PictureSize{BigEndian(file.substr(at + 7, 2)), BigEndian(file.substr(at + 5, 2))};
    const std::uint64_t length = BigEndian(file.substr(at + 2, 2));
    if (length < 2) return {};
    at += 2 + length;
  }
  return {};
}

}  // namespace

std::optional<PictureSize> DeclaredPictureSize(std::string_view file) {
  if (file.starts_with("\x89PNG\r\n\x1a\n"sv) && file.size() >= 24) {
    return PictureSize{BigEndian(file.substr(16, 4)), BigEndian(file.substr(20, 4))};
  }
  if (file.starts_with("\xff\xd8"sv)) return JpegSize(file);
  if (file.starts_with("BM"sv) && file.size() >= 26) {
    // A negative height means rows from the top.
    const auto height = std::int32_t(std::uint32_t(LittleEndian(file.substr(22, 4))));
    return PictureSize{LittleEndian(file.substr(18, 4)), std::uint64_t(std::llabs(height))};
  }
  return {};
}

}  // namespace silt::sim
