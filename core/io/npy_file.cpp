// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/npy_file.h"

#include <bit>
#include <string>

#include "silt/core/atomic_file.h"

namespace silt {
namespace {

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
std::string SizeOf(const Image<T>& image) {
  return std::to_string(image.height()) + ", " + std::to_string(image.width());
}

}  // namespace

void WriteNpy(const std::filesystem::path& file, const Image<float>& image) {
  Write(file, SizeOf(image), image.data(), image.size() * sizeof(float));
}

void WriteNpy(const std::filesystem::path& file, const Image<Vec3f>& image) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  Write(file, SizeOf(image) + ", 3", image.data(), image.size() * sizeof(Vec3f));
}

}  // namespace silt
