// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace silt::sim {

// A 128-bit fingerprint of data, against accidents and not against malice.
class ContentHash {
 public:
  ContentHash& AddBytes(const void* data, std::size_t size);

  template <typename T>
  ContentHash& Add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>);
    return AddBytes(&value, sizeof(value));
  }
  // Elements without padding, such as Vec3f.
  template <typename T>
  ContentHash& AddArray(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    Add(std::uint64_t(values.size()));
    return AddBytes(values.data(), values.size() * sizeof(T));
  }

  // 32 hexadecimal digits.
  std::string Digest() const;

 private:
  std::uint64_t state_[2] = {0x243f6a8885a308d3u, 0x13198a2e03707344u};  // digits of π
};

}  // namespace silt::sim
