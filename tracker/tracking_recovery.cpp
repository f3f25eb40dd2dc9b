// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <vector>

#include "silt/tracker/coarse_initializer.h"
#include "silt/tracker/keyframe_tracker.h"
#include "silt/tracker/relocalization.h"
#include "silt/tracker/trust.h"

// What a KeyframeTracker does with a frame that its motion and its nearest keyframes do not
// explain.
namespace silt::tracker {
namespace {

bool LeavesLessDoubt(const TrackedFrame& a, const TrackedFrame& b, const TrustOptions& trust) {
  if (a.status != b.status) return a.status < b.status;  // as TrackingStatus orders them
  return Doubt(a.evidence, trust) < Doubt(b.evidence, trust);
}

// The time that another try took stays.
void RestoreButTimes(const TrackedFrame& before, TrackedFrame* result) {
  const StageTimes times = result->times;
  *result = before;
  result->times = times;
}

}  // namespace

// A doubtful frame whose images do not agree well, from where the initializer says, which has not
// been asked yet; and one that comes near that, which may be in the wrong one of two minima for
// want of a better start, from where the camera's turn alone leads to, in little time. Of both
// poses the one that leaves less doubt is kept.
void KeyframeTracker::TryAgain(const KeyframeIds& nearest, const SE3d& expected, const Frame& frame,
                               TrackedFrame* result) {
  // Images that are aligned leave a tenth of what makes them doubtful, and sensors up to a third.
  constexpr double near = 0.3;
  const double disagreement = Disagreement(result->evidence, options_.trust);
  if (options_.always_initialize || disagreement <= near) return;
  const TrackedFrame before = *result;
  CoarseInitializer turn(backend_, TurnAlone());
  if (Initialize(disagreement > 1 ? initializer_.get() : &turn, nearest.front(), expected, frame,
                 result)) {
    Refine(nearest, *current_, *result->initial.current_from_keyframe, result);
    if (LeavesLessDoubt(*result, before, options_.trust)) return;
  }
  RestoreButTimes(before, result);
}

// Tries one keyframe after the other, from where the features say or from where it may be; the
// first that leaves no doubt is it.
void KeyframeTracker::Relocalize(const Frame& frame, const CurrentPyramid& current,
                                 const SE3d& expected, TrackedFrame* result) {
  const TrackedFrame before = *result;
  for (const Candidate& candidate : Candidates(before.keyframe_id, frame, expected)) {
    const Keyframe& keyframe = keyframes_[candidate.id];
    result->keyframe_id = candidate.id;
    Initialize(initializer_.get(), candidate.id, candidate.current_from_keyframe, frame, result);
    const SE3d start =
        result->initial.current_from_keyframe.value_or(candidate.current_from_keyframe);
    const SE3d world_from_start = keyframe.world_from_camera * start.Inverse();
    Refine(WithNeighbours(candidate.id, world_from_start), current, start, result);
    if (result->status != TrackingStatus::kTracked) continue;
    Accept(result);
    velocity_.reset();
    return;
  }
  RestoreButTimes(before, result);
}

// The nearest keyframe as seen from where the camera is expected; those that look most like the
// image, where a motion foretells that they are in view; and those from their own places.
std::vector<KeyframeTracker::Candidate> KeyframeTracker::Candidates(int nearest, const Frame& frame,
                                                                    const SE3d& expected) {
  if (options_.relocalization_candidates == 0) return {};
  std::vector<const Image<float>*> thumbnails;
  for (std::size_t i = 0; i < references_.size(); ++i) {
    Image<float>& thumbnail = references_[i].thumbnail;
    if (thumbnail.empty()) thumbnail = Thumbnail(keyframes_[i].frame.rgb);
    thumbnails.push_back(&thumbnail);
  }
  const std::vector<int> alike =
      MostAlike(thumbnails, Thumbnail(frame.rgb), options_.relocalization_candidates);
  const auto seen = [&](int id) {
    return Candidate{id, expected.Inverse() * keyframes_[id].world_from_camera};
  };
  std::vector<Candidate> candidates{seen(nearest)};
  for (const int id : alike) {
    const bool in_view = Overlap(keyframes_[id], expected) >= options_.alignment.min_overlap;
    if (foretold_ && in_view && id != nearest) candidates.push_back(seen(id));
  }
  for (const int id : alike) candidates.push_back({id, {}});
  return candidates;
}

}  // namespace silt::tracker
