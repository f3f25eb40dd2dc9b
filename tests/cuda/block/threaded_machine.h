// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "silt/cuda/block/group_rounds.h"
#include "silt/cuda/block/host_machine.h"

// A machine whose blocks run at once, each by a thread of the host, and meet as a GPU's do: what
// one reads and another one writes without a meeting between them, a race detector sees.
namespace silt::cuda {

struct HostBlock {
  using Counter = std::atomic<unsigned>;

  template <typename Function>
  void Each(const Function& function) const {
    for (int thread = 0; thread < kThreads; ++thread) function(thread);
  }
  void Meet() const {}
  void Raise(Counter& counter) const {
    counter.fetch_add(1, std::memory_order_release);
    counter.notify_all();
  }
  void WaitUntil(const Counter& counter, unsigned expected) const {
    for (unsigned seen = 0; (seen = counter.load(std::memory_order_acquire)) != expected;) {
      counter.wait(seen, std::memory_order_acquire);
    }
  }
};

// As many blocks as are wanted.
template <int kBlocks>
struct ThreadedMachine : HostMachine {
  ThreadedMachine() : HostMachine(ThreadOrder::kForward) {}

  template <typename Body>
  int ResidentBlocks() const {
    return kBlocks;
  }

  template <typename Body>
  void RunGroups(int groups, int blocks, const Body& body, Timer*) const {
    std::vector<GroupBarrier<HostBlock::Counter>> barriers(static_cast<std::size_t>(groups));
    std::vector<std::thread> threads;
    for (int i = 0; i < groups * blocks; ++i) {
      threads.emplace_back([&, i] {
        const auto shared = UnwrittenShared<Body>();
        HostBlock block;
        RunRounds(body, {i / blocks, groups, i % blocks, blocks, 0},
                  barriers[std::size_t(i / blocks)], *shared, block);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
};

}  // namespace silt::cuda
