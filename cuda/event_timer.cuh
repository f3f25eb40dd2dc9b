// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include "silt/cuda/check.cuh"

namespace silt::cuda {

// The time between two places of a stream, by the device's own clock.
class EventTimer {
 public:
  EventTimer() {
    Check(cudaEventCreate(&start_), "making an event");
    Check(cudaEventCreate(&stop_), "making an event");
  }
  ~EventTimer() {
    cudaEventDestroy(start_);
    cudaEventDestroy(stop_);
  }
  EventTimer(const EventTimer&) = delete;
  EventTimer& operator=(const EventTimer&) = delete;

  void Start(cudaStream_t stream) { Check(cudaEventRecord(start_, stream), "recording an event"); }
  void Stop(cudaStream_t stream) { Check(cudaEventRecord(stop_, stream), "recording an event"); }

  // Waits for the second place.
  double Milliseconds() const {
    float milliseconds = 0;
    Check(cudaEventSynchronize(stop_), "waiting for an event");
    Check(cudaEventElapsedTime(&milliseconds, start_, stop_), "reading events");
    return double(milliseconds);
  }

 private:
  cudaEvent_t start_ = nullptr, stop_ = nullptr;
};

}  // namespace silt::cuda
