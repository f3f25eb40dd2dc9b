// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "silt/tracker/graph/pose_graph.h"
#include "silt/tracker/keyframe_tracker.h"

namespace silt::tracker {

struct KeyframeGraphOptions {
  AlignmentOptions alignment;  // of a keyframe with an earlier one
  TrustOptions trust;          // an edge is made of those that leave no doubt
  double min_overlap = 0.4;    // of either in the other's view, as far as the poses tell
  // A new keyframe is aligned with so many earlier ones at most, besides that it was tracked from,
  // and with so many more that are older than the last `recent`: they close loops.
  int neighbours = 2, loops = 2, recent = 10;
};

// A pose graph over a tracker's keyframes that grows beside it and leaves it alone: edges are the
// alignment that each keyframe was tracked by, and those with other keyframes that it shares its
// view with. At each keyframe all poses are optimized.
class KeyframeGraph {
 public:
  KeyframeGraph(const PinholeCamera& camera, const KeyframeGraphOptions& options,
                std::shared_ptr<const Backend> backend);

  // To be called after each frame, with the tracker's keyframes and what it said of the frame.
  void Take(const std::vector<Keyframe>& keyframes, const TrackedFrame& tracked);

  // T_w of the keyframes, by id, after the last optimization.
  const std::vector<SE3d>& keyframe_poses() const { return poses_; }
  // T_w of each frame that was taken: carried by the keyframe that it was tracked from. A lost one
  // stays where the last one was.
  std::vector<SE3d> FramePoses() const;
  const std::vector<PoseEdge>& edges() const { return edges_; }
  int loops() const { return loops_; }  // how many of the edges close one
  const GraphCost& cost() const { return cost_; }

 private:
  struct Carried {
    int keyframe_id = 0;
    SE3d keyframe_from_frame;
  };
  struct Partner {
    double overlap = 0;
    int id = 0;
  };

  void AddKeyframe(const std::vector<Keyframe>& keyframes, const TrackedFrame& tracked);
  std::vector<Partner> Partners(const std::vector<Keyframe>& keyframes, int tracked_from) const;
  bool Connect(const Keyframe& from, const Keyframe& to);

  PinholeCamera camera_;
  KeyframeGraphOptions options_;
  std::shared_ptr<const Backend> backend_;
  std::vector<SE3d> poses_;
  std::vector<PoseEdge> edges_;
  std::vector<Carried> frames_;
  int loops_ = 0;
  GraphCost cost_;
};

}  // namespace silt::tracker
