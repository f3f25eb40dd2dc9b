// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace silt {
namespace {

class ParallelTest : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { SetThreadCount(GetParam()); }
  void TearDown() override { SetThreadCount(0); }
};

TEST_P(ParallelTest, CallsEachIndexOnce) {
  for (int n : {0, 1, 2, 7, 10000}) {
    std::vector<std::atomic<int>> calls(std::size_t(n) + 1);
    ParallelFor(n, [&](int i) { ++calls[std::size_t(i)]; });
    for (int i = 0; i < n; ++i) EXPECT_EQ(calls[std::size_t(i)], 1) << i << " of " << n;
    EXPECT_EQ(calls[std::size_t(n)], 0);
  }
}

TEST_P(ParallelTest, NegativeCountCallsNothing) {
  ParallelFor(-3, [](int) { ADD_FAILURE(); });
}

TEST_P(ParallelTest, KeepsToItsThreads) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  std::atomic<int> inside{0}, most{0};
  ParallelFor(400, [&](int) {
    const int now = ++inside;
    for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
    }
    std::this_thread::sleep_for(std::chrono::microseconds(50));
    --inside;
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  EXPECT_LE(most, ThreadCount());
  if (GetParam() == 1) {
    EXPECT_EQ(ids, std::set{std::this_thread::get_id()});
  }
}

TEST_P(ParallelTest, ExceptionReachesTheCaller) {
  try {
    ParallelFor(1000, [](int i) {
      if (i == 517) throw std::out_of_range("five hundred and seventeen");
    });
    ADD_FAILURE();
  } catch (const std::out_of_range& e) {
    EXPECT_STREQ(e.what(), "five hundred and seventeen");
  }
  int calls = 0;  // and the next loop works
  ParallelFor(1, [&](int) { ++calls; });
  EXPECT_EQ(calls, 1);
}

TEST_P(ParallelTest, LoopsNest) {
  std::vector<std::atomic<int>> calls(64);
  ParallelFor(8,
              [&](int i) { ParallelFor(8, [&, i](int j) { ++calls[std::size_t(8 * i + j)]; }); });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
}

// The rule that all of silt follows: parts per index, added in order.
TEST_P(ParallelTest, OrderedSumHasTheSameBitsOnAnyThreads) {
  std::vector<double> part(5000);
  ParallelFor(5000, [&](int i) { part[std::size_t(i)] = std::sin(double(i)) / (1 + i); });
  const double sum = std::accumulate(part.begin(), part.end(), 0.0);
  static const double first = sum;
  EXPECT_EQ(sum, first);
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelTest, testing::Values(1, 2, 5, 0));

TEST(ThreadCountTest, IsWhatWasSet) {
  for (int threads : {1, 2, 3, 1}) {
    SetThreadCount(threads);
    EXPECT_EQ(ThreadCount(), threads);
  }
  SetThreadCount(0);
  EXPECT_EQ(ThreadCount(), int(std::thread::hardware_concurrency()));
  EXPECT_THROW(SetThreadCount(-1), std::logic_error);
}

}  // namespace
}  // namespace silt
