// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "silt/cuda/check.cuh"
#include "silt/cuda/device_needs.h"
#include "silt/cuda/event_timer.cuh"

namespace silt::cuda {

// Memory of the host that the device reads and writes without another copy.
class PinnedBuffer {
 public:
  PinnedBuffer() = default;
  ~PinnedBuffer() { Report(cudaFreeHost(bytes_), "freeing pinned memory"); }
  PinnedBuffer(const PinnedBuffer&) = delete;
  PinnedBuffer& operator=(const PinnedBuffer&) = delete;

  // Room for so many bytes, once the copy that used it last is done.
  void* Take(std::size_t size) {
    free_.Wait();
    if (size <= size_) return bytes_;
    void* const old = std::exchange(bytes_, nullptr);
    size_ = 0;
    Check(cudaFreeHost(old), "freeing pinned memory");
    Check(cudaMallocHost(&bytes_, size), "allocating pinned memory of the host");
    size_ = size;
    return bytes_;
  }
  void UsedBy(cudaStream_t stream) { free_.Record(stream); }

 private:
  void* bytes_ = nullptr;
  std::size_t size_ = 0;
  Event free_{cudaEventDisableTiming};
};

class StreamHandle {
 public:
  StreamHandle() {
    Check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
  }
  // Once its work is done.
  ~StreamHandle() {
    Report(cudaStreamSynchronize(stream_), "waiting for a stream's end");
    Report(cudaStreamDestroy(stream_), "ending a stream");
  }
  StreamHandle(const StreamHandle&) = delete;
  StreamHandle& operator=(const StreamHandle&) = delete;

  cudaStream_t get() const { return stream_; }

 private:
  cudaStream_t stream_ = nullptr;
};

// A stream with what its copies need: they go through pinned memory, so that those to the device
// return at once. Any number of threads may use it.
class Stream {
 public:
  Stream() { KeepPool(); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  cudaStream_t handle() const { return handle_.get(); }

  void* Allocate(std::size_t bytes) const {
    void* memory = nullptr;
    const cudaError_t status = cudaMallocAsync(&memory, bytes, handle());
    if (status == cudaErrorMemoryAllocation) {
      ForgetLastError();
      throw Error(OutOfMemoryText(bytes));
    }
    Check(status, "allocating device memory");
    return memory;
  }

  // After the work that is on its way.
  void Free(void* memory) const noexcept {
    Report(cudaFreeAsync(memory, handle()), "freeing device memory");
  }

  void CopyToDevice(void* to, const void* from, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    PinnedBuffer& buffer = buffers_[next_++ % buffers_.size()];
    void* const pinned = buffer.Take(bytes);
    std::memcpy(pinned, from, bytes);
    Check(cudaMemcpyAsync(to, pinned, bytes, cudaMemcpyHostToDevice, handle()),
          "copying to the device");
    buffer.UsedBy(handle());
  }

  // Waits for all before it.
  void CopyToHost(void* to, const void* from, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    void* const pinned = results_.Take(bytes);
    Check(cudaMemcpyAsync(pinned, from, bytes, cudaMemcpyDeviceToHost, handle()),
          "copying from the device");
    Check(cudaStreamSynchronize(handle()), "waiting for the device");
    std::memcpy(to, pinned, bytes);
  }

  // Into a buffer that has them once it can be taken again.
  std::unique_ptr<PinnedBuffer> StartCopyToHost(const void* from, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<PinnedBuffer> buffer;
    if (spare_.empty()) {
      buffer = std::make_unique<PinnedBuffer>();
    } else {
      buffer = std::move(spare_.back());
      spare_.pop_back();
    }
    Check(cudaMemcpyAsync(buffer->Take(bytes), from, bytes, cudaMemcpyDeviceToHost, handle()),
          "copying from the device");
    buffer->UsedBy(handle());
    return buffer;
  }
  void TakeBack(std::unique_ptr<PinnedBuffer> buffer) {
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(buffer));
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

  std::mutex mutex_;
  std::array<PinnedBuffer, 4> buffers_;  // colours and depth of one frame and of the next
  std::size_t next_ = 0;
  PinnedBuffer results_;
  std::vector<std::unique_ptr<PinnedBuffer>> spare_;
  StreamHandle handle_;  // is ended first: its copies use the buffers
};

}  // namespace silt::cuda
