// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <mutex>
#include <string>

#include "silt/cuda/check.cuh"

namespace silt::cuda {

// Memory of the host that the device reads and writes without another copy.
class PinnedBuffer {
 public:
  PinnedBuffer() {
    Check(cudaEventCreateWithFlags(&free_, cudaEventDisableTiming), "making an event");
  }
  ~PinnedBuffer() {
    cudaFreeHost(bytes_);
    cudaEventDestroy(free_);
  }
  PinnedBuffer(const PinnedBuffer&) = delete;
  PinnedBuffer& operator=(const PinnedBuffer&) = delete;

  // Room for so many bytes, once the copy that used it last is done.
  void* Take(std::size_t size) {
    Check(cudaEventSynchronize(free_), "waiting for a copy");
    if (size > size_) {
      cudaFreeHost(bytes_);
      bytes_ = nullptr;
      size_ = 0;
      Check(cudaMallocHost(&bytes_, size), "allocating pinned memory of the host");
      size_ = size;
    }
    return bytes_;
  }
  void UsedBy(cudaStream_t stream) { Check(cudaEventRecord(free_, stream), "recording an event"); }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
  cudaEvent_t free_ = nullptr;
};

// A stream with what its copies need: they go through pinned memory, so that those to the device
// return at once. Any number of threads may use it.
class Stream {
 public:
  Stream() {
    Check(cudaStreamCreateWithFlags(&handle_, cudaStreamNonBlocking), "making a stream");
    KeepPool();
  }
  ~Stream() {
    cudaStreamSynchronize(handle_);
    cudaStreamDestroy(handle_);
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  cudaStream_t handle() const { return handle_; }

  void* Allocate(std::size_t bytes) const {
    void* memory = nullptr;
    const cudaError_t status = cudaMallocAsync(&memory, bytes, handle_);
    if (status == cudaErrorMemoryAllocation) {
      cudaGetLastError();  // told below, and nothing is broken
      throw Error("CUDA: the device has no " + std::to_string(bytes >> 20) +
                  " MiB left; use smaller images, fewer keyframes or fewer starts at once");
    }
    Check(status, "allocating device memory");
    return memory;
  }

  void CopyToDevice(void* to, const void* from, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    PinnedBuffer& buffer = buffers_[next_++ % buffers_.size()];
    void* const pinned = buffer.Take(bytes);
    std::memcpy(pinned, from, bytes);
    Check(cudaMemcpyAsync(to, pinned, bytes, cudaMemcpyHostToDevice, handle_),
          "copying to the device");
    buffer.UsedBy(handle_);
  }

  // Waits for all before it.
  void CopyToHost(void* to, const void* from, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    void* const pinned = results_.Take(bytes);
    Check(cudaMemcpyAsync(pinned, from, bytes, cudaMemcpyDeviceToHost, handle_),
          "copying from the device");
    Check(cudaStreamSynchronize(handle_), "waiting for the device");
    std::memcpy(to, pinned, bytes);
  }

 private:
  // What is freed stays with the process: the next frame needs the same.
  static void KeepPool() {
    int device = 0;
    cudaMemPool_t pool = nullptr;
    std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
    Check(cudaGetDevice(&device), "asking for the device");
    Check(cudaDeviceGetDefaultMemPool(&pool, device), "asking for the device's memory pool");
    Check(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all),
          "setting up the memory pool");
  }

  cudaStream_t handle_ = nullptr;
  std::mutex mutex_;
  std::array<PinnedBuffer, 4> buffers_;  // colours and depth of one frame and of the next
  std::size_t next_ = 0;
  PinnedBuffer results_;
};

}  // namespace silt::cuda
