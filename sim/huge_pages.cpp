// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/huge_pages.h"

#include <sys/mman.h>

namespace silt::sim {

namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

std::align_val_t AlignmentOf(std::size_t bytes) {
  return std::align_val_t{bytes >= kHugePage ? kHugePage : 64};
}

}  // namespace

void* AllocateInHugePages(std::size_t bytes) {
  void* memory = ::operator new(bytes, AlignmentOf(bytes));
#ifdef MADV_HUGEPAGE
  // A wish: what the system makes of it changes the speed alone.
  if (bytes >= kHugePage) (void)::madvise(memory, bytes, MADV_HUGEPAGE);
#endif
  return memory;
}

void ReleaseHugePages(void* memory, std::size_t bytes) {
  ::operator delete(memory, AlignmentOf(bytes));
}

}  // namespace silt::sim
