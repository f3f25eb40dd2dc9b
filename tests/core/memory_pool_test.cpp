// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/memory_pool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <set>
#include <vector>

#include "silt/core/parallel.h"

namespace silt {
namespace {

// Small ones and large ones, of which each is written from end to end.
TEST(MemoryPool, NoBlockIsOutTwice) {
  for (const std::size_t bytes : {1, 200, 16384, 1 << 20}) {
    std::vector<unsigned char*> out;
    for (int i = 0; i < 60; ++i) {
      out.push_back(static_cast<unsigned char*>(TakeBlock(bytes)));
      std::memset(out.back(), i, bytes);
    }
    for (int i = 0; i < 60; ++i) {
      EXPECT_EQ(out[std::size_t(i)][0], i) << bytes;
      EXPECT_EQ(out[std::size_t(i)][bytes - 1], i) << bytes;
      ReturnBlock(out[std::size_t(i)], bytes);
    }
  }
  ReturnBlock(nullptr, 200);
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

// Through a pointer to a base that knows of no pool: 100 MB in all, of which little is ever held.
TEST(MemoryPool, ObjectsReturnWhoeverOwnsThem) {
  std::set<const void*> places;
  for (int i = 0; i < 200'000; ++i) {
    const std::unique_ptr<Base> object = std::make_unique<Derived>();
    places.insert(dynamic_cast<void*>(object.get()));
  }
#if !defined(__SANITIZE_ADDRESS__)  // which gives no place out twice before long
  EXPECT_LT(places.size(), 1000u);
#endif
}

}  // namespace
}  // namespace silt
