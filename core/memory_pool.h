// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

// Small blocks of memory that are handed out again: what a tracker needs for one frame it needs for
// the next one too. Any number of threads, and a block may return on another one than it came by.
namespace silt {

// Of a std::pmr pool, aligned as operator new does it; those larger than 16 KiB, and all under
// AddressSanitizer, which is to see their lifetimes, come from operator new.
void* TakeBlock(std::size_t bytes);
// `bytes` as they were asked for.
void ReturnBlock(void* block, std::size_t bytes) noexcept;

template <typename T>
struct PoolAllocator {
  using value_type = T;
  PoolAllocator() = default;
  template <typename U>
  explicit PoolAllocator(const PoolAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(TakeBlock(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { ReturnBlock(p, n * sizeof(T)); }
  template <typename U>
  bool operator==(const PoolAllocator<U>&) const {
    return true;
  }
};

template <typename T>
using PooledVector = std::vector<T, PoolAllocator<T>>;

// A base of classes whose objects lie in such blocks, whoever owns them.
struct Pooled {
  static void* operator new(std::size_t bytes) { return TakeBlock(bytes); }
  static void operator delete(void* block, std::size_t bytes) { ReturnBlock(block, bytes); }
};

}  // namespace silt
