// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "analytic_room.h"
#include "silt/core/parallel.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/keyframe_tracker.h"

namespace {

// Of whatever size, by whatever thread. TBB takes the memory of its tasks from an allocator of its
// own, which is not counted.
std::atomic<int> allocations{0};

void* Allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment, size) != 0) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Those for arrays, and those that do not throw, call these.
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

constexpr PinholeCamera kCamera{481.2, 480, 319.5, 239.5, 640, 480};

// A walk past several keyframes, then to and fro between the last ones.
double PlaceOf(int frame) {
  constexpr int walk = 12;
  if (frame <= walk) return 0.07 * frame;
  const int i = (frame - walk) % 20;
  return 0.07 * walk - 0.01 * (i < 10 ? i : 20 - i);
}

// What each frame asks for, but for those that become keyframes, which keep memory.
std::vector<int> AllocationsPerFrame(const TrackerOptions& options, int threads, int first,
                                     int last) {
  SetThreadCount(threads);
  KeyframeTracker tracker(kCamera, options, MakeCpuBackend(), nullptr);
  std::vector<int> counts;
  for (int i = 0; i < last; ++i) {
    const Frame frame = RoomFrame({{}, {PlaceOf(i), 0, 0}}, i, kCamera);
    const int before = allocations;
    const TrackedFrame tracked = tracker.Track(frame);
    const int count = allocations - before;
    EXPECT_EQ(tracked.status, TrackingStatus::kTracked) << i << ": " << tracked.message;
    if (i >= first && !tracked.new_keyframe) counts.push_back(count);
  }
  EXPECT_GE(tracker.keyframes().size(), 3u);
  SetThreadCount(0);
  return counts;
}

class Allocation : public testing::TestWithParam<TrackerOptions> {};

// Frames at full size, after the walk has brought all that they need.
TEST_P(Allocation, TheSteadyStateNeedsNone) {
  for (const int threads : {2, 1}) {
    const std::vector<int> counts = AllocationsPerFrame(GetParam(), threads, 15, 40);
    EXPECT_GE(counts.size(), 20u);
    for (const int count : counts) EXPECT_EQ(count, 0) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, Allocation, testing::Values(FastPreset(), AccuratePreset()),
                         [](const auto& p) {
                           return std::string(p.index == 0 ? "fast" : "accurate");
                         });

TEST(Allocations, AllAreCounted) {
  const int before = allocations;
  const Image<float> image(8, 8);
  const auto number = std::make_unique<int>(3);
  const std::vector<int> numbers(static_cast<std::size_t>(*number));
  EXPECT_EQ(allocations - before, 3) << image.width() << numbers.size();
}

// The first frames do bring it.
TEST(Allocations, AFrameThatBecomesAKeyframeNeedsMemory) {
  KeyframeTracker tracker(kSmallCamera, FastPreset(), MakeCpuBackend(), nullptr);
  const Frame frame = RoomFrame({}, 0);
  const int before = allocations;
  EXPECT_TRUE(tracker.Track(frame).new_keyframe);
  EXPECT_GT(allocations - before, 5);
}

}  // namespace
}  // namespace silt::tracker
