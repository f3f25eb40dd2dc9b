// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/keyframe_graph.h"

#include <algorithm>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/tracker/view_overlap.h"

namespace silt::tracker {

KeyframeGraph::KeyframeGraph(const PinholeCamera& camera, const KeyframeGraphOptions& options,
                             std::shared_ptr<const Backend> backend)
    : camera_(camera), options_(options), backend_(std::move(backend)) {
  SILT_CHECK(backend_ != nullptr);
  options_.alignment.Validate();
  options_.trust.Validate();
}

void KeyframeGraph::Take(const std::vector<Keyframe>& keyframes, const TrackedFrame& tracked) {
  if (tracked.new_keyframe) AddKeyframe(keyframes, tracked);
  if (tracked.status == TrackingStatus::kLost || tracked.keyframe_id < 0) {
    frames_.push_back(frames_.empty() ? Carried{-1, tracked.world_from_camera} : frames_.back());
    return;
  }
  const int id = tracked.new_keyframe ? keyframes.back().id : tracked.keyframe_id;
  frames_.push_back({id, keyframes[id].world_from_camera.Inverse() * tracked.world_from_camera});
}

void KeyframeGraph::AddKeyframe(const std::vector<Keyframe>& keyframes,
                                const TrackedFrame& tracked) {
  const Keyframe& added = keyframes.back();
  SILT_CHECK(added.id == int(poses_.size()));
  if (added.id == 0) return poses_.push_back(added.world_from_camera);
  const int from = tracked.keyframe_id;
  const SE3d& added_from_tracked = tracked.alignment.current_from_reference;
  poses_.push_back(poses_[from] * added_from_tracked.Inverse());
  edges_.push_back({from, added.id, added_from_tracked, tracked.alignment.covariance});
  for (const Partner& partner : Partners(keyframes, from)) {
    if (Connect(keyframes[partner.id], added) && partner.id < added.id - options_.recent) ++loops_;
  }
  cost_ = OptimizePoses(edges_, &poses_);
}

// Those that share most of their views with the newest keyframe: recent ones, then older ones.
std::vector<KeyframeGraph::Partner> KeyframeGraph::Partners(const std::vector<Keyframe>& keyframes,
                                                            int tracked_from) const {
  const Keyframe& added = keyframes.back();
  std::vector<Partner> recent, old;
  for (const Keyframe& other : keyframes) {
    if (other.id == added.id || other.id == tracked_from) continue;
    const SE3d added_from_other = poses_[added.id].Inverse() * poses_[other.id];
    const double overlap =
        std::min(ViewOverlap(other.frame.depth_m, camera_, added_from_other),
                 ViewOverlap(added.frame.depth_m, camera_, added_from_other.Inverse()));
    if (overlap < options_.min_overlap) continue;
    (other.id < added.id - options_.recent ? old : recent).push_back({overlap, other.id});
  }
  const auto keep_best = [](std::vector<Partner>* partners, int count) {
    std::sort(partners->begin(), partners->end(), [](const Partner& a, const Partner& b) {
      return std::pair(-a.overlap, a.id) < std::pair(-b.overlap, b.id);
    });
    if (int(partners->size()) > count) partners->resize(count);
  };
  keep_best(&recent, options_.neighbours);
  keep_best(&old, options_.loops);
  recent.insert(recent.end(), old.begin(), old.end());
  return recent;
}

// Aligns two keyframes from where the graph has them, and makes an edge of it if it is to be
// trusted.
bool KeyframeGraph::Connect(const Keyframe& from, const Keyframe& to) {
  const AlignmentOptions& options = options_.alignment;
  const Image<float> intensity = GrayFromRgb(from.frame.rgb);
  const auto reference =
      backend_->MakeReference(intensity, from.frame.depth_m, camera_, options.Pyramids());
  const auto current = backend_->MakeCurrent(
      GrayFromRgb(to.frame.rgb), options.use_current_depth ? to.frame.depth_m : Image<float>{},
      options.Pyramids());
  const SE3d start = poses_[to.id].Inverse() * poses_[from.id];
  const ImageContent content = ContentOf(intensity, from.frame.depth_m);
  const ReferenceViews views{{*reference, {}, content.edge_contrast}};
  const AlignmentResult result = Align(*backend_, views, *current, start, options);
  if (!result.ok) return false;
  const PoseEvidence evidence = EvidenceOf(*backend_, views, *current, result, content);
  if (Judge(evidence, options_.trust).status != TrackingStatus::kTracked) return false;
  edges_.push_back({from.id, to.id, result.current_from_reference, result.covariance});
  return true;
}

std::vector<SE3d> KeyframeGraph::FramePoses() const {
  std::vector<SE3d> poses;
  for (const Carried& frame : frames_) {
    poses.push_back(frame.keyframe_id < 0 ? frame.keyframe_from_frame
                                          : poses_[frame.keyframe_id] * frame.keyframe_from_frame);
  }
  return poses;
}

}  // namespace silt::tracker
