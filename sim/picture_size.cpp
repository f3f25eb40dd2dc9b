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
// Decoders skip what lies between segments.
std::optional<PictureSize> JpegSize(std::string_view file) {
  std::size_t at = 2;
  while (at + 9 <= file.size()) {
    const auto marker = static_cast<unsigned char>(file[at + 1]);
    if (file[at] != '\xff' || marker == 0xff || marker == 0) {
      ++at;
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

// From byte 14 on: the size of the header that follows, width and height; of two bytes each in
// OS/2's, else of four, where a negative height means rows from the top.
std::optional<PictureSize> BmpSize(std::string_view file) {
  if (file.size() < 26) return {};
  if (LittleEndian(file.substr(14, 4)) == 12) {
    return PictureSize{LittleEndian(file.substr(18, 2)), LittleEndian(file.substr(20, 2))};
  }
  const auto height = std::int32_t(std::uint32_t(LittleEndian(file.substr(22, 4))));
  return PictureSize{LittleEndian(file.substr(18, 4)), std::uint64_t(std::llabs(height))};
}

// The first directory: a count, then entries of twelve bytes, tag, type, count and value. Tags 256
// and 257 are width and height, of type 3 (two bytes) or 4 (four).
std::optional<PictureSize> TiffSize(std::string_view file) {
  const bool big = file[0] == 'M';
  const auto number = [&](std::size_t at, std::size_t bytes) -> std::uint64_t {
    if (at > file.size() || file.size() - at < bytes) return 0;
    return big ? BigEndian(file.substr(at, bytes)) : LittleEndian(file.substr(at, bytes));
  };
  PictureSize size;
  const std::size_t directory = number(4, 4);
  for (std::size_t i = 0; i < number(directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    const std::uint64_t tag = number(entry, 2);
    const std::uint64_t value = number(entry + 8, number(entry + 2, 2) == 3 ? 2 : 4);
    if (tag == 256) size.width = value;
    if (tag == 257) size.height = value;
  }
  if (size.width == 0 || size.height == 0) return {};
  return size;
}

}  // namespace

std::optional<PictureSize> DeclaredPictureSize(std::string_view file) {
  if (file.starts_with("\x89PNG\r\n\x1a\n"sv) && file.size() >= 24) {
    return PictureSize{BigEndian(file.substr(16, 4)), BigEndian(file.substr(20, 4))};
  }
  if (file.starts_with("\xff\xd8"sv)) return JpegSize(file);
  if (file.starts_with("BM"sv)) return BmpSize(file);
  if (file.starts_with("II*\0"sv) || file.starts_with("MM\0*"sv)) return TiffSize(file);
  return {};
}

}  // namespace silt::sim
