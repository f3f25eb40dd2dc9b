// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/memory_pool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <set>

#include "silt/core/parallel.h"

namespace silt {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kPools = false;
#else
constexpr bool kPools = true;
#endif

TEST(MemoryPool, GivesOutWhatCameBack) {
  if (!kPools) GTEST_SKIP() << "AddressSanitizer sees every lifetime";
  for (const std::size_t bytes : {1, 64, 65, 3000, 16384}) {
    void* const first = TakeBlock(bytes);
    std::memset(first, 1, bytes);
    ReturnBlock(first, bytes);
    void* const second = TakeBlock(bytes);
    EXPECT_EQ(second, first) << bytes;
    ReturnBlock(second, bytes);
  }
}

// A block serves every number of bytes that it holds, and no larger one.
TEST(MemoryPool, BlocksAreLargeEnough) {
  if (!kPools) GTEST_SKIP() << "AddressSanitizer sees every lifetime";
  void* const small = TakeBlock(100);
  ReturnBlock(small, 100);
  void* const same = TakeBlock(128);
  EXPECT_EQ(same, small);
  ReturnBlock(same, 128);
  void* const larger = TakeBlock(129);
  EXPECT_NE(larger, small);
  ReturnBlock(larger, 129);
}

TEST(MemoryPool, NoBlockIsOutTwice) {
  std::set<void*> out;
  for (int i = 0; i < 600; ++i) out.insert(TakeBlock(200));
  EXPECT_EQ(out.size(), 600u);
  for (void* const block : out) ReturnBlock(block, 200);
  ReturnBlock(nullptr, 200);
}

TEST(MemoryPool, LargeOnesAreNotKept) {
  const std::size_t bytes = 1 << 20;
  void* const block = TakeBlock(bytes);
  std::memset(block, 1, bytes);
  ReturnBlock(block, bytes);
}

TEST(MemoryPool, AnyNumberOfThreadsMayUseIt) {
  std::vector<int> sums(64);
  ParallelFor(64, [&](int i) {
    for (int k = 0; k < 200; ++k) {
      const PooledVector<int> numbers(std::size_t(1 + (i * k) % 300), i);
      for (const int number : numbers) sums[std::size_t(i)] += number == i ? 0 : 1;
    }
  });
  for (const int wrong : sums) EXPECT_EQ(wrong, 0);
}

struct Base {
  virtual ~Base() = default;
};
struct Derived : Base, Pooled {
  char rest[500] = {};
};

// Through a pointer to a base that knows of no pool.
TEST(MemoryPool, ObjectsReturnWhoeverOwnsThem) {
  if (!kPools) GTEST_SKIP() << "AddressSanitizer sees every lifetime";
  std::unique_ptr<Base> object = std::make_unique<Derived>();
  const void* const first = dynamic_cast<void*>(object.get());
  object.reset();
  object = std::make_unique<Derived>();
  EXPECT_EQ(dynamic_cast<void*>(object.get()), first);
}

}  // namespace
}  // namespace silt
