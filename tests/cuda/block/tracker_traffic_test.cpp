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

// Its small pictures are made where the large ones lie. Waited for: the counts of the levels of two
// pairs, the outcome of its one stage, and the costs before and after it together.
TEST(TrackerTraffic, ACoarseStartSendsNoPictures) {
  tracker::TrackerOptions options = tracker::FastPreset();
  options.always_initialize = true;
  for (const auto& [use, new_keyframe] : TrackWall(options, 4, true)) {
    EXPECT_LT(use.uploaded_bytes, 1.2 * kFrameBytes);
    if (new_keyframe) continue;
    EXPECT_EQ(use.downloads, 1 + 2 + 1 + 1);
  }
}

}  // namespace
}  // namespace silt::cuda
