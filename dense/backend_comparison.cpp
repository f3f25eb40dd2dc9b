// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/backend_comparison.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/tracker/coarse_initializer.h"
#include "silt/tracker/stopwatch.h"

namespace silt::dense {
namespace {

double Rmse(const TrackedSequence& tracked, const std::vector<RawFrame>& frames) {
  double sum = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Vec3d apart = tracked.poses[i].translation - frames[i].world_from_camera.translation;
    sum += Dot(apart, apart);
  }
  return std::sqrt(sum / double(frames.size()));
}

}  // namespace

TrackedSequence TrackAll(const std::vector<RawFrame>& frames,
                         const tracker::TrackerOptions& options,
                         std::shared_ptr<const tracker::Backend> backend) {
  SILT_CHECK(!frames.empty());
  tracker::TrackerOptions dense = options;
  dense.always_initialize = true;
  dense.start = tracker::Start::kConstantVelocity;
  tracker::KeyframeTracker tracker(
      frames.front().camera, dense, backend,
      std::make_unique<tracker::CoarseInitializer>(backend, tracker::TurnAlone()),
      frames.front().world_from_camera);
  TrackedSequence sequence;
  double milliseconds = 0;
  for (const RawFrame& frame : frames) {
    const tracker::TrackedFrame tracked = tracker.Track(frame.frame);
    sequence.poses.push_back(tracked.world_from_camera);
    sequence.keyframe_ids.push_back(tracked.keyframe_id);
    sequence.new_keyframe.push_back(tracked.new_keyframe);
    sequence.coarse_starts += tracked.initial.current_from_keyframe.has_value();
    sequence.lost += tracked.status == tracker::TrackingStatus::kLost;
    if (sequence.poses.size() > 1) milliseconds += tracked.times.total_ms;
  }
  if (milliseconds > 0) sequence.frames_per_s = 1000 * double(frames.size() - 1) / milliseconds;
  return sequence;
}

bool SequenceDifference::Agree(int frames) const {
  if (metres > 1e-5) return false;
  return same_keyframes == frames || std::abs(rmse_a_m - rmse_b_m) <= 0.1 * rmse_a_m;
}

SequenceDifference Compare(const TrackedSequence& a, const TrackedSequence& b,
                           const std::vector<RawFrame>& frames) {
  SILT_CHECK(a.poses.size() == frames.size() && b.poses.size() == frames.size());
  SequenceDifference difference;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (a.keyframe_ids[i] != b.keyframe_ids[i]) break;
    const Twistd apart = (a.poses[i].Inverse() * b.poses[i]).Log();
    difference.metres = std::max(difference.metres, Norm(apart.v));
    difference.radians = std::max(difference.radians, Norm(apart.omega));
    ++difference.same_keyframes;
    if (a.new_keyframe[i] != b.new_keyframe[i]) break;
  }
  difference.rmse_a_m = Rmse(a, frames);
  difference.rmse_b_m = Rmse(b, frames);
  return difference;
}

}  // namespace silt::dense
