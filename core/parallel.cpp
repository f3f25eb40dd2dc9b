// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/parallel.h"

#include <memory>

#include "silt/core/error.h"

#ifdef SILT_PARALLEL_STD_THREAD
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace silt {

#ifdef SILT_PARALLEL_STD_THREAD
// ThreadSanitizer cannot see through an uninstrumented TBB: its preset takes this path.
namespace {
std::atomic<int> thread_limit{0};
}

int ThreadCount() {
  return thread_limit > 0 ? int(thread_limit) : int(std::thread::hardware_concurrency());
}

void SetThreadCount(int threads) {
  SILT_CHECK(threads >= 0);
  thread_limit = threads;
}

void ParallelFor(int n, const std::function<void(int)>& body) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (int i; (i = next++) < n;) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int t = 1; t < ThreadCount(); ++t) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

#else

int ThreadCount() {
  return int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void SetThreadCount(int threads) {
  SILT_CHECK(threads >= 0);
  // TBB's limit lives as long as this object: for the rest of the process.
  static std::unique_ptr<tbb::global_control> limit;
  limit.reset();
  if (threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  std::size_t(threads));
  }
}

void ParallelFor(int n, const std::function<void(int)>& body) { tbb::parallel_for(0, n, body); }

#endif

}  // namespace silt
