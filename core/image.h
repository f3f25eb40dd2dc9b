// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "silt/core/error.h"

namespace silt {

// A cache line, and the widest SIMD register.
inline constexpr std::size_t kImageAlignment = 64;

template <typename T>
struct ImageAllocator {
  using value_type = T;
  ImageAllocator() = default;
  template <typename U>
  explicit ImageAllocator(const ImageAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{kImageAlignment}));
  }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{kImageAlignment}); }
  template <typename U>
  bool operator==(const ImageAllocator<U>&) const {
    return true;
  }
};

// width × height values, row by row without padding; (x, y) = (column, row), pixel centres at
// integer coordinates, (0, 0) the centre of the upper left pixel.
template <typename T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, T fill = T{})
      : width_(width), height_(height), values_(CheckedSize(width, height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  bool Contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  T& operator()(int x, int y) { return values_[Index(x, y)]; }
  const T& operator()(int x, int y) const { return values_[Index(x, y)]; }
  T* row(int y) { return values_.data() + Index(0, y); }
  const T* row(int y) const { return values_.data() + Index(0, y); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  auto begin() { return values_.begin(); }
  auto begin() const { return values_.begin(); }
  auto end() { return values_.end(); }
  auto end() const { return values_.end(); }

  bool operator==(const Image&) const = default;

 private:
  static std::size_t CheckedSize(int width, int height) {
    SILT_CHECK(width >= 0 && height >= 0);
    return std::size_t(width) * std::size_t(height);
  }
  std::size_t Index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + x; }

  int width_ = 0;
  int height_ = 0;
  std::vector<T, ImageAllocator<T>> values_;
};

// One 8-bit colour, sRGB-encoded.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb8&) const = default;
};

}  // namespace silt
