// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

#include "silt/cuda/block/block.h"
#include "silt/cuda/check.cuh"
#include "silt/cuda/device_needs.h"
#include "silt/cuda/event_timer.cuh"
#include "silt/cuda/group_kernel.cuh"
#include "silt/cuda/stream.cuh"

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

// The device that is current when it is made, with a stream of its own. All work goes through the
// stream in order, and what comes back has been waited for.
class GpuMachine {
 public:
  GpuMachine() : stream_(std::make_shared<Stream>()) {}

  // Device memory from the device's pool, which keeps what is freed for the next.
  template <typename T>
  class Array {
   public:
    Array(const GpuMachine& machine, std::size_t size) : stream_(machine.stream_), size_(size) {
      if (size > 0) values_ = static_cast<T*>(stream_->Allocate(size * sizeof(T)));
    }
    ~Array() {
      if (values_ != nullptr) stream_->Free(values_);
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;

    T* data() { return values_; }
    const T* data() const { return values_; }
    std::size_t size() const { return size_; }

   private:
    std::shared_ptr<Stream> stream_;
    T* values_ = nullptr;
    std::size_t size_;
  };

  template <typename T>
  void Upload(const T* values, Array<T>& to) const {
    if (to.size() > 0) stream_->CopyToDevice(to.data(), values, to.size() * sizeof(T));
  }

  template <typename T>
  std::vector<T> Download(const Array<T>& from) const {
    std::vector<T> host(from.size());
    if (!host.empty()) stream_->CopyToHost(host.data(), from.data(), host.size() * sizeof(T));
    return host;
  }

  // What comes back while the host goes on; whoever takes it waits.
  template <typename T>
  class Coming {
   public:
    Coming(std::shared_ptr<Stream> stream, const Array<T>& from)
        : stream_(std::move(stream)), size_(from.size()) {
      copy_ = stream_->StartCopyToHost(from.data(), size_ * sizeof(T));
    }
    ~Coming() {
      if (copy_) stream_->TakeBack(std::move(copy_));
    }
    Coming(Coming&&) = default;
    Coming& operator=(Coming&&) = delete;

    std::vector<T> Take() {
      const T* const values = static_cast<const T*>(copy_->Take(size_ * sizeof(T)));
      std::vector<T> taken(values, values + size_);
      stream_->TakeBack(std::move(copy_));
      return taken;
    }

   private:
    std::shared_ptr<Stream> stream_;
    std::size_t size_;
    std::unique_ptr<PinnedBuffer> copy_;
  };

  template <typename T>
  Coming<T> StartDownload(const Array<T>& from) const {
    return Coming<T>(stream_, from);
  }

  template <typename Body>
  void Run(const Grid& grid, const Body& body) const {
    RunBody<<<grid.blocks, grid.threads, 0, stream_->handle()>>>(body);
    Check(cudaGetLastError(), "starting a kernel");
  }

  // How many blocks of a body's groups the device can run at once, or fewer if the environment has
  // SILT_CUDA_BLOCKS: tools that watch each access bear with few blocks that wait for each other.
  template <typename Body>
  int ResidentBlocks() const {
    int device = 0, processors = 0, of_processor = 0;
    Check(cudaGetDevice(&device), "asking for the device");
    Check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device),
          "counting processors");
    Check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&of_processor, RunGroupsOf<Body>, kThreads,
                                                        0),
          "asking for the occupancy");
    return LimitedBlocks(processors * of_processor, std::getenv("SILT_CUDA_BLOCKS"));
  }

  // How many alignments a group does in one launch at most: seconds of one kernel would freeze a
  // display that the GPU drives, or have its driver end the process.
  static constexpr int kStartsOfGroup = 16;

  using Timer = EventTimer;
  void Start(Timer* timer) const { timer->Start(stream_->handle()); }
  void Stop(Timer* timer) const { timer->Stop(stream_->handle()); }

  // Does not wait for the end; whoever asks the timer does.
  template <typename Body>
  void RunGroups(int groups, int blocks, const Body& body, Timer* timer) const {
    Array<GroupBarrier<unsigned>> barriers(*this, std::size_t(groups));
    Check(cudaMemsetAsync(barriers.data(), 0, barriers.size() * sizeof(GroupBarrier<unsigned>),
                          stream_->handle()),
          "clearing barriers");
    GroupBarrier<unsigned>* barrier = barriers.data();
    void* arguments[] = {const_cast<Body*>(&body), &blocks, &barrier};
    Start(timer);
    Check(cudaLaunchCooperativeKernel(reinterpret_cast<const void*>(RunGroupsOf<Body>),
                                      groups * blocks, kThreads, arguments, 0, stream_->handle()),
          "starting a kernel of groups");
    Stop(timer);
  }

 private:
  std::shared_ptr<Stream> stream_;
};

}  // namespace silt::cuda
