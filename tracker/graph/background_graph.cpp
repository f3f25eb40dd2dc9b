// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/background_graph.h"

#include <utility>

#include "silt/tracker/stopwatch.h"

namespace silt::tracker {

BackgroundGraph::BackgroundGraph(const PinholeCamera& camera, const KeyframeGraphOptions& options,
                                 std::shared_ptr<const Backend> backend)
    : graph_(camera, options, std::move(backend)) {}

void BackgroundGraph::Take(KeyframeTracker* tracker, TrackedFrame* tracked) {
  if (!tracked->new_keyframe) return;
  {
    const Stopwatch watch(&waited_ms_);
    Wait();
  }
  tracker->MoveKeyframes(graph_.keyframe_poses());
  const Keyframe& added = tracker->keyframes().back();
  tracked->world_from_camera = added.world_from_camera;
  keyframes_.push_back({added.id, added.frame, {}, added.world_from_camera, added.covariance});
  // Of the frame, the alignment alone: the images are in the keyframe.
  work_ =
      std::async(std::launch::async, [this, copy = *tracked] { graph_.Take(keyframes_, copy); });
}

void BackgroundGraph::Wait() {
  if (work_.valid()) work_.get();
}

const KeyframeGraph& BackgroundGraph::Finished() {
  Wait();
  return graph_;
}

}  // namespace silt::tracker
