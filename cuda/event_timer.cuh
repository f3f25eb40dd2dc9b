// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cuda_runtime.h>

#include "silt/cuda/check.cuh"

namespace silt::cuda {

// A place in a stream's work.
class Event {
 public:
  explicit Event(unsigned flags = cudaEventDefault) {
    Check(cudaEventCreateWithFlags(&handle_, flags), "making an event");
  }
  ~Event() { Report(cudaEventDestroy(handle_), "ending an event"); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;

  cudaEvent_t handle() const { return handle_; }
  void Record(cudaStream_t stream) {
    Check(cudaEventRecord(handle_, stream), "recording an event");
  }
  // Until the work before it is done; at once where it was never recorded.
  void Wait() const { Check(cudaEventSynchronize(handle_), "waiting for an event"); }

 private:
  cudaEvent_t handle_ = nullptr;
};

// The time between two places of a stream, by the device's own clock.
class EventTimer {
 public:
  void Start(cudaStream_t stream) { start_.Record(stream); }
  void Stop(cudaStream_t stream) { stop_.Record(stream); }

  // Waits for the second place.
  double Milliseconds() const {
    float milliseconds = 0;
    stop_.Wait();
    Check(cudaEventElapsedTime(&milliseconds, start_.handle(), stop_.handle()), "reading events");
    return double(milliseconds);
  }

 private:
  Event start_, stop_;
};

}  // namespace silt::cuda
