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

// For the outcome of its alignment. What a keyframe's levels have measured comes back by itself and
// is looked at with the next frame.
TEST(TrackerTraffic, AFrameIsWaitedForOnce) {
  const std::vector<FrameTraffic> frames = TrackWall(tracker::AccuratePreset(), 8);
  EXPECT_EQ(frames[0].use.downloads, 0);
  int keyframes = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_EQ(use.downloads, i > 0 ? 1 : 0) << i;
    EXPECT_EQ(use.started_downloads, new_keyframe ? 1 : 0) << i;
    EXPECT_EQ(use.taken_downloads, i > 0 && frames[i - 1].new_keyframe ? 1 : 0) << i;
    EXPECT_LT(use.downloaded_bytes, 4000u) << i;
    EXPECT_EQ(use.uploads, i > 0 ? 5 : 2) << i;
    keyframes += new_keyframe;
  }
  EXPECT_GT(keyframes, 1);
}

// What is going to be a keyframe, as an even motion foretells, is polished in the same launch.
TEST(TrackerTraffic, APolishedFrameIsWaitedForOnceToo) {
  const std::vector<FrameTraffic> frames = TrackWall(tracker::FastPreset(), 12);
  int keyframes = 0;
  for (std::size_t i = 2; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_EQ(use.downloads, 1) << i;
    EXPECT_EQ(use.group_launches, 1) << i;
    EXPECT_EQ(use.started_downloads, new_keyframe ? 1 : 0) << i;
    EXPECT_EQ(use.uploads, 5) << i;
    EXPECT_LT(use.downloaded_bytes, new_keyframe ? 8000u : 3500u) << i;
    keyframes += new_keyframe;
  }
  EXPECT_GT(keyframes, 1);
}

// Where nothing foretells it, it is another answer.
TEST(TrackerTraffic, AFrameThatBecomesAKeyframeUnforeseenIsWaitedForTwice) {
  tracker::TrackerOptions options = tracker::FastPreset();
  options.start = tracker::Start::kPrevious;
  const std::vector<FrameTraffic> frames = TrackWall(options, 8);
  int keyframes = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_EQ(use.downloads, new_keyframe ? 2 : 1) << i;
    EXPECT_EQ(use.uploads, new_keyframe ? 8 : 5) << i;
    keyframes += new_keyframe;
  }
  EXPECT_GT(keyframes, 0);
}

// Its small pictures are made where the large ones lie, and what they lead to starts the refinement
// there. Those of the first keyframe are counted when the
// second frame asks for them, those of a later one with the keyframe: of the stage, and of what is
// compared, of which nobody asks how many there are.
TEST(TrackerTraffic, ACoarseStartIsNotWaitedFor) {
  tracker::TrackerOptions options = tracker::FastPreset();
  options.always_initialize = true;
  const std::vector<FrameTraffic> frames = TrackWall(options, 8, true);
  int keyframes = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& [use, new_keyframe] = frames[i];
    EXPECT_LT(use.uploaded_bytes, 1.2 * kFrameBytes + 16384);
    EXPECT_EQ(use.downloads, 1) << i;
    EXPECT_EQ(use.started_downloads, (i == 1 ? 2 : 0) + (new_keyframe ? 3 : 0)) << i;
    EXPECT_EQ(use.taken_downloads, frames[i - 1].new_keyframe ? 2 : 0) << i;
    keyframes += new_keyframe;
  }
  EXPECT_GT(keyframes, 0);
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

// Step by step, as with a log, the host polishes by itself.
TEST(TrackerTraffic, APolishLeadsWhereItLeadsApart) {
  tracker::TrackerOptions options = tracker::FastPreset();
  const std::shared_ptr<const tracker::Backend> backend =
      MakeEmulatedBackend(ThreadOrder::kForward);
  tracker::KeyframeTracker together(kCamera, options, backend, nullptr);
  options.alignment.keep_log = true;
  tracker::KeyframeTracker apart(kCamera, options, backend, nullptr);
  int polished = 0;
  for (int i = 0; i < 12; ++i) {
    const tracker::TrackedFrame a = together.Track(WallFrame(i)), b = apart.Track(WallFrame(i));
    EXPECT_EQ(a.new_keyframe, b.new_keyframe) << i;
    EXPECT_EQ(a.world_from_camera.translation.x, b.world_from_camera.translation.x) << i;
    EXPECT_EQ(a.world_from_camera.rotation.y, b.world_from_camera.rotation.y) << i;
    EXPECT_EQ(a.covariance, b.covariance) << i;
    EXPECT_EQ(a.alignment.levels.size(), b.alignment.levels.size()) << i;
    polished += i > 0 && a.new_keyframe;
  }
  EXPECT_GT(polished, 1);
}

}  // namespace
}  // namespace silt::cuda
