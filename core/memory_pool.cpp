// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/memory_pool.h"

#include <memory_resource>

namespace silt {
namespace {

std::pmr::memory_resource& Blocks() {
#if defined(__SANITIZE_ADDRESS__)
  return *std::pmr::new_delete_resource();
#else
  // Never destroyed: blocks may return late.
  static auto& pool =
      *new std::pmr::synchronized_pool_resource(std::pmr::pool_options{0, std::size_t(16) << 10});
  return pool;
#endif
}

}  // namespace

void* TakeBlock(std::size_t bytes) { return Blocks().allocate(bytes); }

void ReturnBlock(void* block, std::size_t bytes) noexcept {
  if (block) Blocks().deallocate(block, bytes);
}

}  // namespace silt
