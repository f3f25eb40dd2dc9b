// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracking_run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/colour_registration.h"
#include "silt/experiments/tracker_options.h"
#include "silt/tracker/image_content.h"

namespace silt::experiments {
namespace {

using Stage = double tracker::StageTimes::*;
constexpr Stage kStages[] = {
    &tracker::StageTimes::pyramid_ms,  &tracker::StageTimes::initial_estimate_ms,
    &tracker::StageTimes::residual_ms, &tracker::StageTimes::jacobian_ms,
    &tracker::StageTimes::update_ms,   &tracker::StageTimes::total_ms};

// As the tracker aligns what becomes a keyframe: at full resolution.
tracker::KeyframeGraphOptions GraphOptions(const tracker::TrackerOptions& preset) {
  tracker::KeyframeGraphOptions options{preset.alignment, preset.trust};
  int& finest = options.alignment.max_iterations.front();
  finest = std::max(finest, preset.keyframes.polish_iterations);
  return options;
}

}  // namespace

const char* Name(GraphUse use) {
  switch (use) {
    case GraphUse::kAfterwards:
      return "after";
    case GraphUse::kBackground:
      return "background";
    case GraphUse::kNone:
      break;
  }
  return "none";
}

GraphUse ParseGraphUse(const std::string& name) {
  for (const GraphUse use : {GraphUse::kNone, GraphUse::kAfterwards, GraphUse::kBackground}) {
    if (name == Name(use)) return use;
  }
  throw Error("--graph is '" + name + "'; give after, background or none");
}

int TrackingResult::keyframes() const {
  return int(std::count(is_keyframe.begin(), is_keyframe.end(), true));
}

int TrackingResult::doubtful() const {
  return int(std::count(status.begin(), status.end(), tracker::TrackingStatus::kDoubtful));
}

int TrackingResult::lost() const {
  return int(std::count(status.begin(), status.end(), tracker::TrackingStatus::kLost));
}

TrackingRun::TrackingRun(const PinholeCamera& camera, const TrackerSetup& setup,
                         const SE3d& first_world_from_camera, GraphUse use)
    : choice_(ParseInitializer(setup.initializer)),
      seed_(setup.seed),
      preset_(setup.preset),
      tracker_(MakeTracker(camera, setup, first_world_from_camera)) {
  if (use == GraphUse::kNone) return;
  const tracker::KeyframeGraphOptions options = GraphOptions(PresetOptions(setup.preset));
  if (use == GraphUse::kAfterwards) {
    graph_.emplace(camera, options, MakeBackend(setup.backend));
  } else {
    background_ =
        std::make_unique<tracker::BackgroundGraph>(camera, options, MakeBackend(setup.backend));
  }
}

std::optional<SE3d> TrackingRun::Expected(const std::optional<SE3d>& true_world_from_camera) const {
  if (!choice_.uses_truth()) return {};
  const int frame = int(result_.estimate.size());
  if (!true_world_from_camera) {
    throw Error("--init truth: frame " + std::to_string(frame) +
                " has no true pose; choose another start");
  }
  return PerturbedTruth(*true_world_from_camera, choice_.perturbation, seed_, frame);
}

tracker::TrackedFrame TrackingRun::Track(const Frame& frame,
                                         const std::optional<SE3d>& true_world_from_camera) {
  tracker::TrackedFrame tracked = tracker_.Track(frame, Expected(true_world_from_camera));
  if (graph_) graph_->Take(tracker_.keyframes(), tracked);
  if (background_) background_->Take(&tracker_, &tracked);
  result_.estimate.push_back({tracked.time_s, tracked.world_from_camera});
  result_.is_keyframe.push_back(tracked.new_keyframe);
  result_.status.push_back(tracked.status);
  result_.covariance.push_back(tracked.covariance);
  if (!tracked.message.empty()) {
    result_.messages.push_back("frame " + std::to_string(result_.estimate.size() - 1) + ": " +
                               tracked.message);
  }
  if (tracked.new_keyframe) TellDoubtOfColours(frame);
  for (const Stage stage : kStages) sums_.*stage += tracked.times.*stage;
  return tracked;
}

// Once: the camera stays the same.
void TrackingRun::TellDoubtOfColours(const Frame& keyframe) {
  if (told_doubt_of_colours_) return;
  const double contrast = tracker::ContentOf(keyframe.rgb, keyframe.depth_m).edge_contrast;
  const std::string doubt = DoubtOfColours(preset_, contrast);
  if (doubt.empty()) return;
  told_doubt_of_colours_ = true;
  result_.messages.push_back("frame " + std::to_string(result_.estimate.size() - 1) + ": " + doubt);
}

TrackingResult TrackingRun::Result() const {
  TrackingResult result = result_;
  const double frames = std::max<double>(1, double(result.estimate.size()));
  for (const Stage stage : kStages) result.mean_times.*stage = sums_.*stage / frames;
  if (!graph_) return result;
  const std::vector<SE3d> poses = graph_->FramePoses();
  for (std::size_t i = 0; i < poses.size(); ++i) result.estimate[i].world_from_camera = poses[i];
  return result;
}

std::vector<tracker::Keyframe> TrackingRun::Keyframes() const {
  std::vector<tracker::Keyframe> keyframes = tracker_.keyframes();
  if (!graph_) return keyframes;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    keyframes[i].world_from_camera = graph_->keyframe_poses()[i];
  }
  return keyframes;
}

Json TrackingRun::GraphJson() const {
  if (!graph_ && !background_) return nullptr;
  const tracker::KeyframeGraph& graph = graph_ ? *graph_ : background_->Finished();
  Json json{{"edges", graph.edges().size()},
            {"loops", graph.loops()},
            {"cost_before_the_last_keyframe", graph.cost().before},
            {"cost", graph.cost().after}};
  if (background_) json["waited_ms"] = background_->waited_ms();
  return json;
}

}  // namespace silt::experiments
