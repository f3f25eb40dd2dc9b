// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "silt/cuda/block/block.h"

namespace silt::cuda {

// In what order the threads of a block come. Code that is right gives the same bits in both.
enum class ThreadOrder { kForward, kBackward };

// What a machine was asked to do.
struct MachineUse {
  int uploads = 0, downloads = 0;  // a download is waited for
  int started_downloads = 0, taken_downloads = 0;
  std::size_t uploaded_bytes = 0, downloaded_bytes = 0;
  int group_launches = 0;
  std::size_t held_bytes = 0, most_held_bytes = 0;  // of arrays
};

// Runs kernels on the CPU, one block after the other, each phase for all threads of a block: what a
// GPU may do, barriers and order of summation included. Its interface is what BlockBackend asks of
// a machine; see GpuMachine for the other.
class HostMachine {
 public:
  // Counts in `use`, if it is given, and is then for one thread alone.
  explicit HostMachine(ThreadOrder order, std::shared_ptr<MachineUse> use = nullptr)
      : order_(order), use_(std::move(use)) {}

  template <typename T>
  class Array {
   public:
    Array(const HostMachine& machine, std::size_t size) : values_(size), use_(machine.use_) {
      FillWithOnes(values_.data(), size);
      if (!use_) return;
      use_->held_bytes += size * sizeof(T);
      use_->most_held_bytes = std::max(use_->most_held_bytes, use_->held_bytes);
    }
    ~Array() {
      if (use_) use_->held_bytes -= size() * sizeof(T);
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    T* data() { return values_.data(); }
    const T* data() const { return values_.data(); }
    std::size_t size() const { return values_.size(); }

   private:
    std::vector<T> values_;
    std::shared_ptr<MachineUse> use_;
  };

  template <typename T>
  void Upload(const T* values, Array<T>& to) const {
    for (std::size_t i = 0; i < to.size(); ++i) to.data()[i] = values[i];
    if (!use_) return;
    ++use_->uploads;
    use_->uploaded_bytes += to.size() * sizeof(T);
  }

  template <typename T>
  std::vector<T> Download(const Array<T>& from) const {
    if (use_) {
      ++use_->downloads;
      use_->downloaded_bytes += from.size() * sizeof(T);
    }
    return std::vector<T>(from.data(), from.data() + from.size());
  }

  // What comes back while the host goes on; whoever takes it waits.
  template <typename T>
  class Coming {
   public:
    Coming(std::vector<T> values, std::shared_ptr<MachineUse> use)
        : values_(std::move(values)), use_(std::move(use)) {}
    std::vector<T> Take() {
      if (use_) ++use_->taken_downloads;
      return std::move(values_);
    }

   private:
    std::vector<T> values_;
    std::shared_ptr<MachineUse> use_;
  };

  template <typename T>
  Coming<T> StartDownload(const Array<T>& from) const {
    if (use_) {
      ++use_->started_downloads;
      use_->downloaded_bytes += from.size() * sizeof(T);
    }
    return {std::vector<T>(from.data(), from.data() + from.size()), use_};
  }

  template <typename Body>
  void Run(const Grid& grid, const Body& body) const {
    const auto shared = UnwrittenShared<Body>();
    for (int i = 0; i < grid.blocks; ++i) {
      const int block = Ordered(i, grid.blocks);
      for (int phase = 0; phase < Body::kPhases; ++phase) {
        for (int j = 0; j < grid.threads; ++j) {
          body.Run(phase, {block, Ordered(j, grid.threads), grid}, *shared);
        }
      }
    }
  }

  // So many blocks could meet at once: enough for groups of several, not as many as units.
  template <typename Body>
  int ResidentBlocks() const {
    return order_ == ThreadOrder::kForward ? 5 : 4;
  }

  // What a launch took by the machine's own clock, of which it has none.
  struct Timer {
    double Milliseconds() const { return 0; }
  };
  void Start(Timer*) const {}
  void Stop(Timer*) const {}

  // Few, so that small batches take several launches.
  static constexpr int kStartsOfGroup = 2;

  // Groups one after the other; in each round every block does all of its work before the first one
  // decides, and that before any goes on.
  template <typename Body>
  void RunGroups(int groups, int blocks, const Body& body, Timer*) const {
    if (use_) ++use_->group_launches;
    for (int i = 0; i < groups; ++i) {
      const int group = Ordered(i, groups);
      std::vector<std::unique_ptr<typename Body::Shared>> shared;
      for (int j = 0; j < blocks; ++j) shared.push_back(UnwrittenShared<Body>());
      const GroupPlace first{group, groups, 0, blocks, 0};
      for (Decide(first, body, *shared[0]); !body.Finished(first);
           Decide(first, body, *shared[0])) {
        for (int j = 0; j < blocks; ++j) {
          const int block = Ordered(j, blocks);
          Work({group, groups, block, blocks, 0}, body, *shared[block]);
        }
      }
    }
  }

  // Of a block, as RunGroups and Run find it.
  template <typename Body>
  static std::unique_ptr<typename Body::Shared> UnwrittenShared() {
    auto shared = std::make_unique<typename Body::Shared>();
    FillWithOnes(shared.get(), 1);
    return shared;
  }

 private:
  // Memory that nobody has written yet holds what no code can take for a value that is meant: NaN,
  // or an index of −1.
  template <typename T>
  static void FillWithOnes(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>, "a GPU's memory holds plain data alone");
    if (count > 0) std::memset(static_cast<void*>(values), 0xFF, count * sizeof(T));
  }

  int Ordered(int i, int n) const { return order_ == ThreadOrder::kForward ? i : n - 1 - i; }

  template <typename Body>
  void Work(GroupPlace place, const Body& body, typename Body::Shared& shared) const {
    const int phases = body.WorkPhases(place);
    for (int phase = 0; phase < phases; ++phase) {
      for (int i = 0; i < kThreads; ++i) {
        place.thread = Ordered(i, kThreads);
        body.Work(phase, place, shared);
      }
    }
  }

  template <typename Body>
  void Decide(GroupPlace place, const Body& body, typename Body::Shared& shared) const {
    const int phases = body.DecidePhases(place);
    for (int phase = 0; phase < phases; ++phase) {
      for (int i = 0; i < kThreads; ++i) {
        place.thread = Ordered(i, kThreads);
        body.Decide(phase, phases, place, shared);
      }
    }
  }

  ThreadOrder order_;
  std::shared_ptr<MachineUse> use_;
};

}  // namespace silt::cuda
