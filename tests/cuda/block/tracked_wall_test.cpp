// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "moving_wall.h"
#include "silt/tracker/coarse_initializer.h"
#include "silt/tracker/keyframe_tracker.h"

// A tracker whose images lie in a machine, frame by frame.
namespace silt::cuda {
namespace {

using tracker::KeyframeTracker;
using tracker::TrackedFrame;
using tracker::TrackerOptions;

std::vector<TrackedFrame> TrackWall(const std::shared_ptr<const tracker::Backend>& backend,
                                    const TrackerOptions& options) {
  auto coarse = std::make_unique<tracker::CoarseInitializer>(backend, tracker::TurnAlone());
  KeyframeTracker tracker(kCamera, options, backend, std::move(coarse));
  std::vector<TrackedFrame> tracked;
  for (int i = 0; i < 8; ++i) tracked.push_back(tracker.Track(WallFrame(i)));
  return tracked;
}

bool SamePose(const SE3d& a, const SE3d& b) {
  return a.rotation.w == b.rotation.w && a.rotation.x == b.rotation.x &&
         a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z &&
         a.translation.x == b.translation.x && a.translation.y == b.translation.y &&
         a.translation.z == b.translation.z;
}

std::vector<TrackerOptions> Presets() {
  std::vector<TrackerOptions> presets{tracker::PaperPreset(), tracker::AccuratePreset(),
                                      tracker::FastPreset()};
  presets.push_back(presets[2]);
  presets.back().always_initialize = true;
  return presets;
}

class TrackedWallOn : public BackendTest {};
INSTANTIATE_BACKENDS(TrackedWallOn);

TEST_P(TrackedWallOn, IsWhereTheCpuSeesIt) {
  const std::shared_ptr<const tracker::Backend> block = std::move(block_);
  for (const TrackerOptions& options : Presets()) {
    const auto ours = TrackWall(block, options);
    const auto cpus = TrackWall(tracker::MakeCpuBackend(), options);
    int keyframes = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      ASSERT_EQ(ours[i].status, tracker::TrackingStatus::kTracked) << ours[i].message;
      ASSERT_EQ(ours[i].keyframe_id, cpus[i].keyframe_id) << i;
      EXPECT_EQ(ours[i].new_keyframe, cpus[i].new_keyframe) << i;
      const Twistd apart = (ours[i].world_from_camera.Inverse() * cpus[i].world_from_camera).Log();
      EXPECT_LT(Norm(apart.v), 1e-5) << i;
      EXPECT_LT(Norm(apart.omega), 1e-5) << i;
      const Twistd error = (ours[i].world_from_camera.Inverse() * WallPose(int(i))).Log();
      EXPECT_LT(Norm(error.v), 5e-3) << i;
      keyframes += ours[i].new_keyframe;
    }
    EXPECT_GT(keyframes, 1);
  }
}

// In the same backend and in another one on the same device.
TEST_P(TrackedWallOn, HasTheSameBitsEveryTime) {
  const std::shared_ptr<const tracker::Backend> block = std::move(block_);
  const std::shared_ptr<const tracker::Backend> other = MakeBackendOn(GetParam());
  for (const TrackerOptions& options : {tracker::PaperPreset(), tracker::FastPreset()}) {
    const auto once = TrackWall(block, options);
    for (const auto& backend : {block, other}) {
      const auto again = TrackWall(backend, options);
      for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_TRUE(SamePose(again[i].world_from_camera, once[i].world_from_camera)) << i;
        EXPECT_EQ(again[i].covariance, once[i].covariance) << i;
      }
    }
  }
}

}  // namespace
}  // namespace silt::cuda
