// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "analytic_room.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/keyframe_tracker.h"

namespace {

// An image of the coarsest level is larger.
constexpr std::size_t kLarge = 1024;
std::atomic<int> large_allocations{0};

void* Allocate(std::size_t size, std::size_t alignment) {
  if (size >= kLarge) ++large_allocations;
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment, size) != 0) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return Allocate(size, std::size_t(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace silt::tracker {
namespace {

// After the first frames, of which one is the keyframe, no frame asks for memory for images.
void ExpectSteady(const TrackerOptions& options) {
  KeyframeTracker tracker(kSmallCamera, options, MakeCpuBackend(), nullptr);
  for (int i = 0; i < 3; ++i) tracker.Track(RoomFrame({{}, {0.005 * i, 0, 0}}, i));
  const Frame frame = RoomFrame({{}, {0.015, 0, 0}}, 3);
  const int before = large_allocations;
  const TrackedFrame tracked = tracker.Track(frame);
  EXPECT_EQ(large_allocations - before, 0);
  EXPECT_EQ(tracked.status, TrackingStatus::kTracked);
  EXPECT_EQ(tracker.keyframes().size(), 1u);
}

TEST(Allocation, LargeOnesAreCounted) {
  const int before = large_allocations;
  const Image<float> image(64, 64);
  EXPECT_EQ(large_allocations - before, 1) << image.width();
}

TEST(Allocation, TheSteadyStateOfFastNeedsNone) { ExpectSteady(FastPreset()); }
TEST(Allocation, TheSteadyStateOfAccurateNeedsNone) { ExpectSteady(AccuratePreset()); }

}  // namespace
}  // namespace silt::tracker
