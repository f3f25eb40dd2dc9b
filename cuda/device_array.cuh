// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "silt/cuda/check.cuh"
#include "silt/cuda/device_needs.h"

namespace silt::cuda {

// Values in device memory, owned.
template <typename T>
class DeviceArray {
 public:
  explicit DeviceArray(std::size_t size) : size_(size) {
    if (size == 0) return;
    const cudaError_t status = cudaMalloc(&values_, size * sizeof(T));
    if (status == cudaErrorMemoryAllocation) {
      ForgetLastError();
      throw Error(OutOfMemoryText(size * sizeof(T)));
    }
    Check(status, "allocating device memory");
  }
  DeviceArray(const T* host, std::size_t size) : DeviceArray(size) {
    if (size > 0) {
      Check(cudaMemcpy(values_, host, size * sizeof(T), cudaMemcpyHostToDevice),
            "copying to the device");
    }
  }
  ~DeviceArray() { Report(cudaFree(values_), "freeing device memory"); }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;

  T* data() { return values_; }
  const T* data() const { return values_; }

  // Waits for the kernels before it.
  std::vector<T> ToHost() const {
    std::vector<T> host(size_);
    if (size_ > 0) {
      Check(cudaMemcpy(host.data(), values_, size_ * sizeof(T), cudaMemcpyDeviceToHost),
            "copying from the device");
    }
    return host;
  }

 private:
  T* values_ = nullptr;
  std::size_t size_;
};

}  // namespace silt::cuda
