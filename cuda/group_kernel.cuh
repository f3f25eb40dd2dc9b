// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include "silt/cuda/block/block.h"

namespace silt::cuda {

// How the blocks of a group meet: both numbers only grow.
struct GroupBarrier {
  unsigned arrived = 0;   // blocks other than the first, over all rounds
  unsigned released = 0;  // decisions that the first has made
};

__device__ inline void SpinUntil(const unsigned* value, unsigned expected) {
  while (*const_cast<const volatile unsigned*>(value) != expected) {
  }
}

// The first block of a group waits until the work of `round` rounds is done by all the others.
__device__ inline void WaitForOthers(const GroupBarrier* barrier, unsigned round, int blocks) {
  __syncthreads();
  if (threadIdx.x == 0 && blocks > 1) {
    SpinUntil(&barrier->arrived, round * unsigned(blocks - 1));
    __threadfence();
  }
  __syncthreads();
}

// It then lets them go on.
__device__ inline void Release(GroupBarrier* barrier, int blocks) {
  __syncthreads();
  if (threadIdx.x == 0 && blocks > 1) {
    __threadfence();
    atomicAdd(&barrier->released, 1u);
  }
}

// Another block tells that it has done its work of `round` rounds, and waits for the next decision.
__device__ inline void WaitForDecision(GroupBarrier* barrier, unsigned round) {
  __syncthreads();
  if (threadIdx.x == 0) {
    __threadfence();
    if (round > 0) atomicAdd(&barrier->arrived, 1u);
    SpinUntil(&barrier->released, round + 1);
    __threadfence();
  }
  __syncthreads();
}

// See AlignBody for what a body is. All blocks of the grid must be resident.
template <typename Body>
__global__ void __launch_bounds__(kThreads, 2)
    RunGroupsOf(const Body body, int blocks, GroupBarrier* barriers) {
  __shared__ alignas(16) unsigned char storage[sizeof(typename Body::Shared)];
  auto& shared = *reinterpret_cast<typename Body::Shared*>(storage);
  const GroupPlace place{int(blockIdx.x) / blocks, int(gridDim.x) / blocks,
                         int(blockIdx.x) % blocks, blocks, int(threadIdx.x)};
  GroupBarrier* barrier = barriers + place.group;
  for (unsigned round = 0;; ++round) {
    if (place.block == 0) {
      WaitForOthers(barrier, round, blocks);
      const int phases = body.DecidePhases(place);
      for (int phase = 0; phase < phases; ++phase) {
        __syncthreads();
        body.Decide(phase, phases, place, shared);
      }
      Release(barrier, blocks);
    } else {
      WaitForDecision(barrier, round);
    }
    if (body.Finished(place)) return;
    const int phases = body.WorkPhases(place);
    for (int phase = 0; phase < phases; ++phase) {
      if (phase > 0) __syncthreads();
      body.Work(phase, place, shared);
    }
  }
}

}  // namespace silt::cuda
