// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "silt/cuda/block.h"

namespace silt::cuda {

// In what order the threads of a block come. Code that is right gives the same bits in both.
enum class ThreadOrder { kForward, kBackward };

// Runs kernels on the CPU, one block after the other, each phase for all threads of a block: what a
// GPU may do, barriers and order of summation included. Its interface is what BlockBackend asks of
// a machine; see GpuMachine for the other.
class HostMachine {
 public:
  explicit HostMachine(ThreadOrder order) : order_(order) {}

  template <typename T>
  class Array {
   public:
    Array(const HostMachine&, std::size_t size) : values_(size) {}
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    std::size_t size() const { return values_.size(); }

   private:
    std::vector<T> values_;
  };

  template <typename T>
  void Upload(const T* values, Array<T>& to) const {
    for (std::size_t i = 0; i < to.size(); ++i) to.data()[i] = values[i];
  }

  template <typename T>
  std::vector<T> Download(const Array<T>& from) const {
    return std::vector<T>(from.data(), from.data() + from.size());
  }

  template <typename Body>
  void Run(const Grid& grid, const Body& body) const {
    const auto shared = std::make_unique<typename Body::Shared>();
    for (int i = 0; i < grid.blocks; ++i) {
      const int block = order_ == ThreadOrder::kForward ? i : grid.blocks - 1 - i;
      for (int phase = 0; phase < Body::kPhases; ++phase) {
        for (int j = 0; j < grid.threads; ++j) {
          const int thread = order_ == ThreadOrder::kForward ? j : grid.threads - 1 - j;
          body.Run(phase, {block, thread, grid}, *shared);
        }
      }
    }
  }

 private:
  ThreadOrder order_;
};

}  // namespace silt::cuda
