// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "moving_wall.h"
#include "silt/tracker/coarse_initializer.h"
#include "silt/tracker/keyframe_tracker.h"

// What a tracker sends to a machine, and how often it waits for an answer.
namespace silt::cuda {
namespace {

struct FrameTraffic {
  MachineUse use;
  bool new_keyframe = false;
};

std::vector<FrameTraffic> TrackWall(const tracker::TrackerOptions& options, int frames,
                                    bool coarse_starts = false) {
  const auto use = std::make_shared<MachineUse>();
  const std::shared_ptr<const tracker::Backend> backend =
      MakeEmulatedBackend(ThreadOrder::kForward, use);
  std::unique_ptr<tracker::Initializer> initializer;
  if (coarse_starts) {
    initializer = std::make_unique<tracker::CoarseInitializer>(backend, tracker::TurnAlone());
  }
  tracker::KeyframeTracker tracker(kCamera, options, backend, std::move(initializer));
  std::vector<FrameTraffic> all;
  for (int i = 0; i < frames; ++i) {
    *use = {};
    const tracker::TrackedFrame tracked = tracker.Track(WallFrame(i));
    EXPECT_EQ(tracked.status, tracker::TrackingStatus::kTracked) << i << tracked.message;
    all.push_back({*use, tracked.new_keyframe});
  }
  return all;
}

// Three bytes of colour and a depth for each pixel.
constexpr std::size_t kFrameBytes = std::size_t(kCamera.width * kCamera.height) * (3 + 4);

// With what says how to align it.
TEST(TrackerTraffic, AFrameGoesUpOnce) {
  const std::vector<FrameTraffic> frames = TrackWall(tracker::FastPreset(), 8);
  int keyframes = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_GE(use.uploaded_bytes, kFrameBytes);
    EXPECT_LT(use.uploaded_bytes, 1.2 * kFrameBytes) << i << (new_keyframe ? " keyframe" : "");
    keyframes += new_keyframe;
  }
  EXPECT_GT(keyframes, 0);
}

// The outcome of its alignment; of a keyframe, the counts of its levels and the polished outcome
// with the counts at full resolution.
TEST(TrackerTraffic, AFrameIsWaitedForOnce) {
  const std::vector<FrameTraffic> frames = TrackWall(tracker::FastPreset(), 8);
  EXPECT_EQ(frames[0].use.downloads, 1);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].use.downloads, frames[i].new_keyframe ? 4 : 1) << i;
    EXPECT_EQ(frames[i].use.uploads, frames[i].new_keyframe ? 8 : 5) << i;
    EXPECT_LT(frames[i].use.downloaded_bytes, frames[i].new_keyframe ? 8000u : 3500u) << i;
  }
}

// Its small pictures are made where the large ones lie, and what they lead to starts the refinement
// there. After a keyframe, the counts of its small pictures are waited for, those of the stage and
// those that are compared, once.
TEST(TrackerTraffic, ACoarseStartIsNotWaitedFor) {
  tracker::TrackerOptions options = tracker::FastPreset();
  options.always_initialize = true;
  const std::vector<FrameTraffic> frames = TrackWall(options, 8, true);
  int plain = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_LT(use.uploaded_bytes, 1.2 * kFrameBytes + 16384);
    const int counts = frames[i - 1].new_keyframe ? 2 : 0;
    EXPECT_EQ(use.downloads, (new_keyframe ? 4 : 1) + counts) << i;
    plain += !new_keyframe && counts == 0;
  }
  EXPECT_GT(plain, 0);
}

// The initializer of a tracker that asks for the estimate first.
struct Apart : tracker::Initializer {
  explicit Apart(std::shared_ptr<const tracker::Backend> backend)
      : coarse(std::move(backend), tracker::TurnAlone()) {}
  tracker::InitialEstimate Estimate(const tracker::InitializerInput& input) override {
    return coarse.Estimate(input);
  }
  bool needs_intensities(const tracker::Backend& backend) const override {
    return coarse.needs_intensities(backend);
  }
  tracker::CoarseInitializer coarse;
};

TEST(TrackerTraffic, ACoarseStartLeadsWhereItLeadsApart) {
  tracker::TrackerOptions options = tracker::FastPreset();
  options.always_initialize = true;
  const std::shared_ptr<const tracker::Backend> backend =
      MakeEmulatedBackend(ThreadOrder::kForward);
  tracker::KeyframeTracker together(
      kCamera, options, backend,
      std::make_unique<tracker::CoarseInitializer>(backend, tracker::TurnAlone()));
  tracker::KeyframeTracker apart(kCamera, options, backend, std::make_unique<Apart>(backend));
  int found = 0;
  for (int i = 0; i < 6; ++i) {
    const tracker::TrackedFrame a = together.Track(WallFrame(i)), b = apart.Track(WallFrame(i));
    EXPECT_EQ(a.world_from_camera.translation.x, b.world_from_camera.translation.x) << i;
    EXPECT_EQ(a.world_from_camera.rotation.y, b.world_from_camera.rotation.y) << i;
    const auto &start = a.initial.current_from_keyframe, &other = b.initial.current_from_keyframe;
    ASSERT_EQ(start.has_value(), other.has_value()) << i;
    if (!start) continue;
    ++found;
    EXPECT_EQ(start->rotation.y, other->rotation.y) << i;
  }
  EXPECT_GT(found, 2);
}

}  // namespace
}  // namespace silt::cuda
