// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "silt/cuda/block.h"
#include "silt/cuda/check.cuh"

namespace silt::cuda {

template <typename Body>
__global__ void __launch_bounds__(kThreads) RunBody(Body body) {
  __shared__ typename Body::Shared shared;
  const Place place{int(blockIdx.x), int(threadIdx.x), {int(gridDim.x), int(blockDim.x)}};
#pragma unroll
  for (int phase = 0; phase < Body::kPhases; ++phase) {
    if (phase > 0) __syncthreads();
    body.Run(phase, place, shared);
  }
}

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

// The device that is current when it is made, with a stream of its own. All work goes through the
// stream in order, and what comes back has been waited for.
class GpuMachine {
  struct Stream {
    Stream() {
      Check(cudaStreamCreateWithFlags(&handle, cudaStreamNonBlocking), "making a stream");
    }
    ~Stream() { cudaStreamDestroy(handle); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    cudaStream_t handle = nullptr;
  };

 public:
  GpuMachine() : stream_(std::make_shared<Stream>()) {}

  // Device memory from the device's pool, which keeps what is freed for the next.
  template <typename T>
  class Array {
   public:
    Array(const GpuMachine& machine, std::size_t size) : stream_(machine.stream_), size_(size) {
      if (size == 0) return;
      Check(cudaMallocAsync(&values_, size * sizeof(T), stream_->handle),
            "allocating device memory");
    }
    ~Array() {
      if (values_ != nullptr) cudaFreeAsync(values_, stream_->handle);
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;

    T* data() { return values_; }
    const T* data() const { return values_; }
    std::size_t size() const { return size_; }

   private:
    std::shared_ptr<const Stream> stream_;
    T* values_ = nullptr;
    std::size_t size_;
  };

  template <typename T>
  void Upload(const T* values, Array<T>& to) const {
    if (to.size() == 0) return;
    Check(cudaMemcpyAsync(to.data(), values, to.size() * sizeof(T), cudaMemcpyHostToDevice,
                          stream_->handle),
          "copying to the device");
  }

  template <typename T>
  std::vector<T> Download(const Array<T>& from) const {
    std::vector<T> host(from.size());
    if (!host.empty()) {
      Check(cudaMemcpyAsync(host.data(), from.data(), host.size() * sizeof(T),
                            cudaMemcpyDeviceToHost, stream_->handle),
            "copying from the device");
      Check(cudaStreamSynchronize(stream_->handle), "waiting for the device");
    }
    return host;
  }

  template <typename Body>
  void Run(const Grid& grid, const Body& body) const {
    RunBody<<<grid.blocks, grid.threads, 0, stream_->handle>>>(body);
    Check(cudaGetLastError(), "starting a kernel");
  }

  // How many blocks of a body's groups the device can run at once.
  template <typename Body>
  int ResidentBlocks() const {
    int device = 0, processors = 0, of_processor = 0;
    Check(cudaGetDevice(&device), "asking for the device");
    Check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device),
          "counting processors");
    Check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&of_processor, RunGroupsOf<Body>, kThreads,
                                                        0),
          "asking for the occupancy");
    return processors * of_processor;
  }

  template <typename Body>
  void RunGroups(int groups, int blocks, const Body& body) const {
    Array<GroupBarrier> barriers(*this, std::size_t(groups));
    Check(cudaMemsetAsync(barriers.data(), 0, barriers.size() * sizeof(GroupBarrier),
                          stream_->handle),
          "clearing barriers");
    GroupBarrier* barrier = barriers.data();
    void* arguments[] = {const_cast<Body*>(&body), &blocks, &barrier};
    Check(cudaLaunchCooperativeKernel(reinterpret_cast<const void*>(RunGroupsOf<Body>),
                                      groups * blocks, kThreads, arguments, 0, stream_->handle),
          "starting a kernel of groups");
  }

 private:
  std::shared_ptr<const Stream> stream_;
};

}  // namespace silt::cuda
