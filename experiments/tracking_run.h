// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/trajectory.h"
#include "silt/experiments/json.h"
#include "silt/experiments/tracker_setup.h"
#include "silt/tracker/graph/background_graph.h"
#include "silt/tracker/graph/keyframe_graph.h"

namespace silt::experiments {

// What a tracker made of a sequence, frame by frame.
struct TrackingResult {
  Trajectory estimate;
  std::vector<bool> is_keyframe;                 // per frame: it became one
  std::vector<tracker::TrackingStatus> status;   // per frame
  std::vector<tracker::Covariance6> covariance;  // per frame, see TrackedFrame
  tracker::StageTimes mean_times;                // per frame
  std::vector<std::string> messages;             // one line each, for people

  int keyframes() const;
  int doubtful() const;
  int lost() const;  // their poses are the last that was not
};

// What a graph over the keyframes does for a run.
enum class GraphUse {
  kNone,
  kAfterwards,  // all poses are told as it corrects them in the end
  kBackground,  // poses are the tracker's, whose keyframes it moves on the way
};

// "none", "after", "background"; ParseGraphUse throws silt::Error for anything else.
const char* Name(GraphUse use);
GraphUse ParseGraphUse(const std::string& name);

// One tracker that is fed a sequence, and a graph over its keyframes if wanted.
class TrackingRun {
 public:
  TrackingRun(const PinholeCamera& camera, const TrackerSetup& setup,
              const SE3d& first_world_from_camera, GraphUse use = GraphUse::kNone);

  // The true pose is where the frame's alignment starts if the setup says so, and nothing else.
  // Throws silt::Error where it is wanted and there is none.
  tracker::TrackedFrame Track(const Frame& frame,
                              const std::optional<SE3d>& true_world_from_camera = std::nullopt);
  TrackingResult Result() const;
  std::vector<tracker::Keyframe> Keyframes() const;
  Json GraphJson() const;  // its edges, loops and cost; null without one

 private:
  void TellDoubtOfColours(const Frame& keyframe);
  std::optional<SE3d> Expected(const std::optional<SE3d>& true_world_from_camera) const;

  InitializerChoice choice_;
  std::uint64_t seed_;
  std::string preset_;
  bool told_doubt_of_colours_ = false;
  tracker::KeyframeTracker tracker_;
  std::optional<tracker::KeyframeGraph> graph_;
  std::unique_ptr<tracker::BackgroundGraph> background_;
  TrackingResult result_;
  tracker::StageTimes sums_;
};

}  // namespace silt::experiments
