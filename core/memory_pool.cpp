// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/memory_pool.h"

#include <bit>
#include <mutex>
#include <new>

namespace silt {
namespace {

constexpr std::size_t kLeastBytes = 64;
constexpr int kSizes = 9;  // each twice the one before: up to 16 KiB
constexpr int kMostIdle = 256;
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kPools = false;
#else
constexpr bool kPools = true;
#endif

struct IdleBlock {
  IdleBlock* next;
};

// Of one size. Lives as long as the process, without a destructor: blocks may return late.
struct IdleBlocks {
  std::mutex mutex;
  IdleBlock* first = nullptr;
  int count = 0;
};
constinit IdleBlocks idle_blocks[kSizes];

int SizeIndex(std::size_t bytes) {
  return bytes <= kLeastBytes ? 0 : int(std::bit_width((bytes - 1) / kLeastBytes));
}
bool IsPooled(std::size_t bytes) { return kPools && SizeIndex(bytes) < kSizes; }

}  // namespace

void* TakeBlock(std::size_t bytes) {
  if (!IsPooled(bytes)) return ::operator new(bytes);
  const int size = SizeIndex(bytes);
  IdleBlocks& idle = idle_blocks[size];
  {
    const std::lock_guard lock(idle.mutex);
    if (IdleBlock* const block = idle.first) {
      idle.first = block->next;
      --idle.count;
      return block;
    }
  }
  return ::operator new(kLeastBytes << size);
}

void ReturnBlock(void* block, std::size_t bytes) noexcept {
  if (!block) return;
  if (IsPooled(bytes)) {
    IdleBlocks& idle = idle_blocks[SizeIndex(bytes)];
    const std::lock_guard lock(idle.mutex);
    if (idle.count < kMostIdle) {
      idle.first = ::new (block) IdleBlock{idle.first};
      ++idle.count;
      return;
    }
  }
  ::operator delete(block);
}

}  // namespace silt
