// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "silt/tracker/graph/keyframe_graph.h"
#include "silt/tracker/keyframe_tracker.h"

namespace silt::tracker {

// A graph over a tracker's keyframes that is optimized on a thread of its own while tracking goes
// on, and that moves the tracker's keyframes. What is begun at one keyframe is taken over at the
// next one, however long it takes: poses do not depend on timing or on the number of threads.
class BackgroundGraph {
 public:
  // The backend must not be the tracker's, unless that may be used by two threads at once.
  BackgroundGraph(const PinholeCamera& camera, const KeyframeGraphOptions& options,
                  std::shared_ptr<const Backend> backend);

  // To be called after each frame with what the tracker said of it, whose pose is corrected where
  // the frame is a keyframe. Throws what the thread threw.
  void Take(KeyframeTracker* tracker, TrackedFrame* tracked);

  // With all keyframes; waits for the thread.
  const KeyframeGraph& Finished();
  // For how long Take had to wait for the thread, all together.
  double waited_ms() const { return waited_ms_; }

 private:
  void Wait();

  double waited_ms_ = 0;
  KeyframeGraph graph_;              // the thread's while work_ is under way,
  std::vector<Keyframe> keyframes_;  // like its copy of the keyframes
  std::future<void> work_;           // waits for the thread when destroyed: it comes last
};

}  // namespace silt::tracker
