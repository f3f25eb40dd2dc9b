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

 private:
  std::shared_ptr<const Stream> stream_;
};

}  // namespace silt::cuda
