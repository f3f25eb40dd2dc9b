// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/npy_file.h"

#include <bit>
#include <fstream>
#include <string>
#include <type_traits>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"

namespace silt {
namespace {

static_assert(sizeof(Vec3f) == 3 * sizeof(float));
static_assert(std::endian::native == std::endian::little, "the files are little-endian");

// Magic, version 1.0, length of the text, and the text, padded so that the data begin at a multiple
// of 64 bytes.
std::string Header(const std::string& shape) {
  std::string text = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + shape + "), }";
  constexpr std::size_t kBefore = 10, kAlignment = 64;
  text.append(kAlignment - (kBefore + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(text.size() % 256) + char(text.size() / 256) +
         text;
}

void Write(const std::filesystem::path& file, const std::string& shape, const void* data,
           std::size_t size) {
  WriteFileAtomically(file, Header(shape).append(static_cast<const char*>(data), size));
}

template <typename T>
std::string ShapeOf(const Image<T>& image) {
  const std::string size = std::to_string(image.height()) + ", " + std::to_string(image.width());
  return std::is_same_v<T, Vec3f> ? size + ", 3" : size;
}

}  // namespace

void WriteNpy(const std::filesystem::path& file, const Image<float>& image) {
  Write(file, ShapeOf(image), image.data(), image.size() * sizeof(float));
}

void WriteNpy(const std::filesystem::path& file, const Image<Vec3f>& image) {
  Write(file, ShapeOf(image), image.data(), image.size() * sizeof(Vec3f));
}

Image<Vec3f> ReadNpy(const std::filesystem::path& file, int width, int height) {
  Image<Vec3f> image(width, height);
  const std::string header = Header(ShapeOf(image));
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(file.string() + ": cannot be read");
  std::string found(header.size(), '\0');
  in.read(found.data(), std::streamsize(found.size()));
  in.read(reinterpret_cast<char*>(image.data()), std::streamsize(image.size() * sizeof(Vec3f)));
  if (!in || found != header || in.peek() != std::ifstream::traits_type::eof()) {
    throw Error(file.string() + ": is not an image of " + std::to_string(width) + "x" +
                std::to_string(height) + " pixels of three floats as silt writes them; remove it");
  }
  return image;
}

}  // namespace silt
