// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include "silt/cuda/block/group_rounds.h"

namespace silt::cuda {

// A block of a GPU, seen by one of its threads: the first one speaks for all.
struct GpuBlock {
  using Counter = unsigned;

  template <typename Function>
  __device__ void Each(const Function& function) const {
    function(int(threadIdx.x));
  }
  __device__ void Meet() const { __syncthreads(); }
  __device__ void Raise(unsigned& counter) const {
    if (threadIdx.x != 0) return;
    __threadfence();
    atomicAdd(&counter, 1u);
  }
  __device__ void WaitUntil(const unsigned& counter, unsigned expected) const {
    if (threadIdx.x != 0) return;
    while (*const_cast<const volatile unsigned*>(&counter) != expected) {
    }
    __threadfence();
  }
};

// See AlignBody for what a body is. All blocks of the grid must be resident.
template <typename Body>
__global__ void __launch_bounds__(kThreads, 2)
    RunGroupsOf(const Body body, int blocks, GroupBarrier<unsigned>* barriers) {
  __shared__ alignas(16) unsigned char storage[sizeof(typename Body::Shared)];
  auto& shared = *reinterpret_cast<typename Body::Shared*>(storage);
  const GroupPlace place{int(blockIdx.x) / blocks, int(gridDim.x) / blocks,
                         int(blockIdx.x) % blocks, blocks, int(threadIdx.x)};
  GpuBlock block;
  RunRounds(body, place, barriers[place.group], shared, block);
}

}  // namespace silt::cuda
