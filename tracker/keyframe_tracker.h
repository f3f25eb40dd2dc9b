// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/se3.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/initializer.h"
#include "silt/tracker/keyframe.h"
#include "silt/tracker/options.h"
#include "silt/tracker/trust.h"

namespace silt::tracker {

// The stages of §4.1, in milliseconds; total_ms also holds what no stage claims.
struct StageTimes {
  double pyramid_ms = 0;  // gray image and pyramids of the current frame, and of a new keyframe
  double initial_estimate_ms = 0;
  double residual_ms = 0;  // warped image and residual
  double jacobian_ms = 0;
  double update_ms = 0;  // solve and pose update
  double total_ms = 0;
};

struct TrackedFrame {
  double time_s = 0;
  TrackingStatus status = TrackingStatus::kLost;
  std::string message;     // one line where not tracked, or where it could not be a keyframe
  PoseEvidence evidence;   // where an alignment came about
  SE3d world_from_camera;  // the last one that was not lost where lost
  // Of ξ = (ω, v) in the camera's frame, the true pose being world_from_camera·exp(ξ): that of the
  // alignment and that of the keyframe. The first pose counts as exact. Zeros where lost.
  Covariance6 covariance{};
  int keyframe_id = -1;       // that the pose was estimated against; of the first frame, its own
  bool new_keyframe = false;  // this frame has become a keyframe
  InitialEstimate initial;
  AlignmentResult alignment;
  StageTimes times;
};

// §3: the camera's pose, frame by frame, against the nearest of the keyframes collected so far.
class KeyframeTracker {
 public:
  // Where the initializer does not give every frame its start, it is asked where an alignment from
  // elsewhere is lost or leaves images that hardly agree. No initializer: each alignment starts
  // from the last pose. Throws silt::Error for invalid options.
  KeyframeTracker(const PinholeCamera& camera, const TrackerOptions& options,
                  std::shared_ptr<const Backend> backend, std::unique_ptr<Initializer> initializer,
                  const SE3d& first_world_from_camera = {});
  ~KeyframeTracker();

  // The next frame; the first one with a depth becomes the first keyframe. Throws silt::Error where
  // an image is not of the camera's size.
  // `expected_world_from_camera` replaces the start that the tracker would foretell itself.
  TrackedFrame Track(const Frame& frame,
                     const std::optional<SE3d>& expected_world_from_camera = std::nullopt);
  // The same without a copy of the frame where it becomes a keyframe; else it is left alone.
  TrackedFrame Track(Frame&& frame,
                     const std::optional<SE3d>& expected_world_from_camera = std::nullopt);

  // In the order of creation: keyframes()[i].id == i.
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }

  // Moves the keyframes, by id, to where they are known to be by now. Later ones than that go with
  // those that they were tracked from, and so does the camera. Covariances stay.
  void MoveKeyframes(const std::vector<SE3d>& world_from_keyframe);

 private:
  // What the backend and the judgement need of a keyframe.
  struct Reference {
    std::unique_ptr<ReferencePyramid> pyramid;
    ImageContent content;
    Image<float> thumbnail;               // empty until the camera is lost
    int tracked_from = 0;                 // the keyframe; of the first one, itself
    double least_unexplained = HUGE_VAL;  // of the variance, by a frame that was tracked from it
    bool stale = false;                   // nothing is aligned with it that can be with another
  };

  // A keyframe that a lost camera may be looking at, and where from.
  struct Candidate {
    int id = 0;
    SE3d current_from_keyframe;
  };

  // A frame, and whether it may be taken for a keyframe instead of being copied.
  struct Given {
    const Frame& frame;
    Frame* movable;
  };

  TrackedFrame TrackGiven(const Given& given, const std::optional<SE3d>& expected);
  void CheckFrame(const Frame& frame) const;
  void Localize(const Frame& frame, const SE3d& expected, TrackedFrame* result);
  SE3d Predicted(double time_s) const;
  // Whether it finds a start, which a null one does not.
  bool Initialize(Initializer* initializer, int keyframe, const SE3d& expected, const Frame& frame,
                  TrackedFrame* result);
  void MakeIntensities(int keyframe, const Frame& frame, TrackedFrame* result);
  std::unique_ptr<const CurrentPyramid> MakeCurrent(const Frame& frame, TrackedFrame* result) const;
  std::unique_ptr<ReferencePyramid> MakeReference(const Frame& frame) const;
  // What the initializer looks at; pyramids that the backend holds among it.
  InitializerInput InputOf(int keyframe, const SE3d& expected, const Frame& frame) const;
  std::optional<CoarseStart> StartOf(int keyframe, const SE3d& expected, const Frame& frame,
                                     TrackedFrame* result) const;
  // From `initial`, or where `first` leads to from there.
  void Refine(const KeyframeIds& nearest, const CurrentPyramid& current, const SE3d& initial,
              TrackedFrame* result, const CoarseStart* first = nullptr,
              const Polish* last = nullptr);
  void TryAgain(const KeyframeIds& nearest, const SE3d& expected, const Frame& frame,
                TrackedFrame* result);
  void Relocalize(const Frame& frame, const CurrentPyramid& current, const SE3d& expected,
                  TrackedFrame* result);
  std::vector<Candidate> Candidates(int nearest, const Frame& frame, const SE3d& expected);
  double Overlap(const Keyframe& keyframe, const SE3d& world_from_camera) const;
  KeyframeIds Seen(KeyframeIds ids, const SE3d& world_from_camera) const;
  KeyframeIds WithNeighbours(int id, const SE3d& world_from_camera) const;
  void Accept(TrackedFrame* result);
  SE3d PoseOf(TrackedFrame* result) const;
  bool NeedsNewKeyframe(const TrackedFrame& result) const;
  bool ShowsWhatNoneKnows(const SE3d& world_from_camera) const;
  bool HasGoneStale(const TrackedFrame& result) const;
  void RetireStale(const TrackedFrame& result);
  void PolishPose(const Frame& frame, TrackedFrame* result);
  std::optional<Polish> PolishOf(int keyframe, const Frame& frame, TrackedFrame* result) const;
  OwnedPair FullResolution(int keyframe, const Frame& frame, const AlignmentOptions& options) const;
  void MakeKeyframe(const Given& given, TrackedFrame* result);

  PinholeCamera camera_;
  TrackerOptions options_;
  std::shared_ptr<const Backend> backend_;
  std::unique_ptr<Initializer> initializer_;
  Image<float> gray_;                              // in [0, 1], for the initializer
  int gray_frame_index_ = -1;                      // of the frame that it is of
  std::unique_ptr<const CurrentPyramid> current_;  // of the frame that is being tracked
  std::vector<Keyframe> keyframes_;
  std::vector<Reference> references_;  // of keyframes_
  KeyframeIds aligned_with_;           // the keyframes that this frame was
  SE3d world_from_camera_;             // of the last tracked frame
  int tracked_from_ = 0;               // the keyframe of that frame; itself where it is one
  double time_s_ = 0;                  // of that frame
  std::optional<Twistd> velocity_;     // per second, in its camera's frame; nothing when unknown
  bool foretold_ = false;              // where this frame is, by a motion or by the caller
  int frame_index_ = 0;
};

}  // namespace silt::tracker
