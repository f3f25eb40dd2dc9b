// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracking_run.h"

#include <algorithm>

namespace silt::experiments {
namespace {

using Stage = double tracker::StageTimes::*;
constexpr Stage kStages[] = {
    &tracker::StageTimes::pyramid_ms,  &tracker::StageTimes::initial_estimate_ms,
    &tracker::StageTimes::residual_ms, &tracker::StageTimes::jacobian_ms,
    &tracker::StageTimes::update_ms,   &tracker::StageTimes::total_ms};

}  // namespace

int TrackingResult::keyframes() const {
  return int(std::count(is_keyframe.begin(), is_keyframe.end(), true));
}

int TrackingResult::lost() const { return int(std::count(is_lost.begin(), is_lost.end(), true)); }

TrackingRun::TrackingRun(const PinholeCamera& camera, const TrackerSetup& setup,
                         const SE3d& first_world_from_camera)
    : tracker_(MakeTracker(camera, setup, first_world_from_camera)) {}

tracker::TrackedFrame TrackingRun::Track(const Frame& frame) {
  tracker::TrackedFrame tracked = tracker_.Track(frame);
  result_.estimate.push_back({tracked.time_s, tracked.world_from_camera});
  result_.is_keyframe.push_back(tracked.new_keyframe);
  result_.is_lost.push_back(tracked.status == tracker::TrackingStatus::kLost);
  if (!tracked.message.empty()) {
    result_.messages.push_back("frame " + std::to_string(result_.estimate.size() - 1) + ": " +
                               tracked.message);
  }
  for (const Stage stage : kStages) sums_.*stage += tracked.times.*stage;
  return tracked;
}

TrackingResult TrackingRun::Result() const {
  TrackingResult result = result_;
  const double frames = std::max<double>(1, double(result.estimate.size()));
  for (const Stage stage : kStages) result.mean_times.*stage = sums_.*stage / frames;
  return result;
}

}  // namespace silt::experiments
