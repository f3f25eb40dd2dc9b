// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace silt::sim {

// Memory for arrays that are read here and there: in pages of 2 MiB where the system has them, so
// that fewer look-ups miss the processor's table of pages. Aligned to a cache line.
void* AllocateInHugePages(std::size_t bytes);
void ReleaseHugePages(void* memory, std::size_t bytes);

template <typename T>
struct HugePageAllocator {
  using value_type = T;
  HugePageAllocator() = default;
  template <typename U>
  explicit HugePageAllocator(const HugePageAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(AllocateInHugePages(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { ReleaseHugePages(p, n * sizeof(T)); }
  template <typename U>
  bool operator==(const HugePageAllocator<U>&) const {
    return true;
  }
};

template <typename T>
using HugePageVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace silt::sim
