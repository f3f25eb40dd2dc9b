// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "silt/core/host_device.h"

// How the GPU's code is written so that a CPU can run it too, block by block: see HostMachine. A
// kernel's body is plain data with
//
//   static constexpr int kPhases;  // between any two of them, all threads of a block meet
//   struct Shared;                 // of a block
//   void Run(int phase, const Place&, Shared&) const;  // one thread's part, on host and device
//
// Within a phase, no thread may read what another one of the grid writes in it.
namespace silt::cuda {

struct Grid {
  int blocks = 1, threads = 1;  // per block
};

// One thread of a grid.
struct Place {
  int block = 0, thread = 0;
  Grid grid;

  SILT_HOST_DEVICE int index() const { return block * grid.threads + thread; }
  SILT_HOST_DEVICE int count() const { return grid.blocks * grid.threads; }
};

inline constexpr int kThreads = 256;  // of a block, unless a body says otherwise

// A thread of a grid whose blocks form groups that work independently of each other.
struct GroupPlace {
  int group = 0, groups = 1;
  int block = 0, blocks = 1;  // of the group
  int thread = 0;             // of kThreads
};

// Enough blocks to give each thread up to `items_per_thread` of n items; it depends on n alone, and
// so does the order in which sums are formed.
inline Grid GridFor(int n, int items_per_thread = 1) {
  const int per_block = kThreads * items_per_thread;
  const int blocks = (n + per_block - 1) / per_block;
  return {blocks > 0 ? blocks : 1, kThreads};
}

// The body that calls each(i) once for every i in [0, n).
template <typename Each>
struct ForEach {
  static constexpr int kPhases = 1;
  struct Shared {};
  int n;
  Each each;

  SILT_HOST_DEVICE void Run(int, const Place& place, Shared&) const {
    for (int i = place.index(); i < n; i += place.count()) each(i);
  }
};

// *least = min(*least, value) for values that are not negative. The result does not depend on the
// order in which threads get there.
SILT_HOST_DEVICE inline void AtomicMin(float* least, float value) {
#ifdef __CUDA_ARCH__
  // As integers, the bits of floats that are not negative have the same order.
  atomicMin(reinterpret_cast<int*>(least), __float_as_int(value));
#else
  const std::atomic_ref<float> place(*least);
  float seen = place.load(std::memory_order_relaxed);
  while (value < seen && !place.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
#endif
}

}  // namespace silt::cuda
