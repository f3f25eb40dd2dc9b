// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe_tracker.h"

#include <algorithm>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/tracker/stopwatch.h"
#include "silt/tracker/view_overlap.h"

namespace silt::tracker {
namespace {

void CheckSize(const char* what, int width, int height, const PinholeCamera& camera, int frame) {
  if (width == camera.width && height == camera.height) return;
  throw Error("frame " + std::to_string(frame) + ": its " + what + " has " + std::to_string(width) +
              "x" + std::to_string(height) + " pixels and the camera " +
              std::to_string(camera.width) + "x" + std::to_string(camera.height) +
              "; give images of the camera's size");
}

void AddTimes(const AlignmentTimes& times, StageTimes* sum) {
  sum->residual_ms += times.residual_ms;
  sum->jacobian_ms += times.jacobian_ms;
  sum->update_ms += times.update_ms;
}

}  // namespace

KeyframeTracker::KeyframeTracker(const PinholeCamera& camera, const TrackerOptions& options,
                                 std::shared_ptr<const Backend> backend,
                                 std::unique_ptr<Initializer> initializer,
                                 const SE3d& first_world_from_camera)
    : camera_(camera),
      options_(options),
      backend_(std::move(backend)),
      initializer_(std::move(initializer)),
      world_from_camera_(first_world_from_camera) {
  SILT_CHECK(backend_ != nullptr);
  options_.Validate();
  backend_->CheckHas(options_.alignment, options_.keyframes.joint);
}

KeyframeTracker::~KeyframeTracker() = default;

TrackedFrame KeyframeTracker::Track(const Frame& frame,
                                    const std::optional<SE3d>& expected_world_from_camera) {
  return TrackGiven({frame, nullptr}, expected_world_from_camera);
}

TrackedFrame KeyframeTracker::Track(Frame&& frame,
                                    const std::optional<SE3d>& expected_world_from_camera) {
  return TrackGiven({frame, &frame}, expected_world_from_camera);
}

TrackedFrame KeyframeTracker::TrackGiven(const Given& given,
                                         const std::optional<SE3d>& expected_world_from_camera) {
  const Frame& frame = given.frame;
  CheckFrame(frame);
  TrackedFrame result;
  result.time_s = frame.time_s;
  {
    const Stopwatch total(&result.times.total_ms);
    current_.reset();
    // The first frame is the first keyframe; later ones are aligned with the nearest keyframe.
    if (!keyframes_.empty()) {
      const SE3d expected = expected_world_from_camera.value_or(Predicted(frame.time_s));
      foretold_ = expected_world_from_camera.has_value() || velocity_.has_value();
      Localize(frame, expected, &result);
    }
    if (NeedsNewKeyframe(result)) {
      RetireStale(result);
      PolishPose(frame, &result);
      MakeKeyframe(given, &result);
    }
    current_.reset();
  }
  result.world_from_camera = world_from_camera_;
  ++frame_index_;
  return result;
}

void KeyframeTracker::CheckFrame(const Frame& frame) const {
  CheckSize("image", frame.rgb.width(), frame.rgb.height(), camera_, frame_index_);
  if (frame.depth_m.empty()) return;
  CheckSize("depth", frame.depth_m.width(), frame.depth_m.height(), camera_, frame_index_);
}

void KeyframeTracker::Localize(const Frame& frame, const SE3d& expected, TrackedFrame* result) {
  // The position of the previous image defines the nearest keyframe (§3.1).
  const KeyframeIds nearest =
      Seen(NearestKeyframes(keyframes_, options_.always_initialize ? world_from_camera_ : expected,
                            options_.keyframes, options_.keyframes.joint),
           expected);
  const Keyframe& keyframe = keyframes_[nearest.front()];
  result->keyframe_id = keyframe.id;
  current_ = MakeCurrent(frame, result);
  // Initial T_cr (§3.2), then its refinement (§3.3).
  const SE3d start = expected.Inverse() * keyframe.world_from_camera;
  std::optional<CoarseStart> first;
  if (options_.always_initialize) {
    first = StartOf(keyframe.id, start, frame, result);
    if (!first) Initialize(initializer_.get(), keyframe.id, start, frame, result);
  }
  // Where it is foretold that the frame will become a keyframe, it is polished in one go.
  std::optional<Polish> last;
  if (backend_->runs_alignments() &&
      (NeedsKeyframe(keyframes_, expected, options_.keyframes) || ShowsWhatNoneKnows(expected))) {
    last = PolishOf(keyframe.id, frame, result);
  }
  Refine(nearest, *current_, result->initial.current_from_keyframe.value_or(start), result,
         first ? &*first : nullptr, last ? &*last : nullptr);
  if (first) result->initial.current_from_keyframe = result->alignment.coarse;
  if (result->status != TrackingStatus::kLost) TryAgain(nearest, start, frame, result);
  if (result->status == TrackingStatus::kLost) {
    velocity_.reset();
    Relocalize(frame, *current_, expected, result);
  } else {
    Accept(result);
  }
}

double KeyframeTracker::Overlap(const Keyframe& keyframe, const SE3d& world_from_camera) const {
  return ViewOverlap(keyframe.frame.depth_m, camera_,
                     world_from_camera.Inverse() * keyframe.world_from_camera);
}

// Those that an alignment can do something with; the first where there are none.
KeyframeIds KeyframeTracker::Seen(KeyframeIds ids, const SE3d& world_from_camera) const {
  const int first = ids.front();
  if (ids.size() == 1) return ids;
  std::erase_if(ids, [&](int id) {
    return (id != first && references_[id].stale) ||
           Overlap(keyframes_[id], world_from_camera) < options_.alignment.min_overlap;
  });
  return ids.empty() ? KeyframeIds{first} : ids;
}

// A keyframe, and the nearest others in view that are aligned with together with it.
KeyframeIds KeyframeTracker::WithNeighbours(int id, const SE3d& world_from_camera) const {
  KeyframeIds all{id};
  for (const int near : Seen(NearestKeyframes(keyframes_, world_from_camera, options_.keyframes,
                                              options_.keyframes.joint),
                             world_from_camera)) {
    if (near != id && int(all.size()) < options_.keyframes.joint) all.push_back(near);
  }
  return all;
}

SE3d KeyframeTracker::Predicted(double time_s) const {
  if (options_.start == Start::kKeyframe) {
    const int nearest = NearestKeyframe(keyframes_, world_from_camera_, options_.keyframes);
    return keyframes_[nearest].world_from_camera;
  }
  if (options_.start == Start::kPrevious || !velocity_) return world_from_camera_;
  const double dt_s = time_s - time_s_;
  return world_from_camera_ * SE3d::Exp({dt_s * velocity_->omega, dt_s * velocity_->v});
}

// T_wc = T_w,near · T_near,c, with its covariance.
SE3d KeyframeTracker::PoseOf(TrackedFrame* result) const {
  const Keyframe& keyframe = keyframes_[result->keyframe_id];
  const SE3d& current_from_keyframe = result->alignment.current_from_reference;
  result->covariance =
      Sum(result->alignment.covariance, InFrame(keyframe.covariance, current_from_keyframe));
  return keyframe.world_from_camera * current_from_keyframe.Inverse();
}

void KeyframeTracker::Accept(TrackedFrame* result) {
  const SE3d world_from_camera = PoseOf(result);
  double& least = references_[result->keyframe_id].least_unexplained;
  least = std::min(least, result->evidence.unexplained_variance);
  const double dt_s = result->time_s - time_s_;
  velocity_.reset();
  if (dt_s > 0) {
    const Twistd moved = (world_from_camera_.Inverse() * world_from_camera).Log();
    velocity_ = Twistd{1 / dt_s * moved.omega, 1 / dt_s * moved.v};
  }
  world_from_camera_ = world_from_camera;
  tracked_from_ = result->keyframe_id;
  time_s_ = result->time_s;
}

void KeyframeTracker::MoveKeyframes(const std::vector<SE3d>& world_from_keyframe) {
  SILT_CHECK(world_from_keyframe.size() <= keyframes_.size());
  std::vector<SE3d> moves;  // new world from old world, by keyframe
  for (Keyframe& keyframe : keyframes_) {
    const std::size_t id = moves.size();
    if (id < world_from_keyframe.size()) {
      moves.push_back(world_from_keyframe[id] * keyframe.world_from_camera.Inverse());
      keyframe.world_from_camera = world_from_keyframe[id];
    } else {
      moves.push_back(id > 0 ? moves[references_[id].tracked_from] : SE3d{});
      keyframe.world_from_camera = moves[id] * keyframe.world_from_camera;
    }
  }
  if (!moves.empty()) world_from_camera_ = moves[tracked_from_] * world_from_camera_;
}

bool KeyframeTracker::Initialize(Initializer* initializer, int keyframe, const SE3d& expected,
                                 const Frame& frame, TrackedFrame* result) {
  if (!initializer) return false;
  if (initializer->needs_intensities(*backend_)) MakeIntensities(keyframe, frame, result);
  const Stopwatch watch(&result->times.initial_estimate_ms);
  result->initial = initializer->Estimate(InputOf(keyframe, expected, frame));
  return result->initial.current_from_keyframe.has_value();
}

InitializerInput KeyframeTracker::InputOf(int keyframe, const SE3d& expected,
                                          const Frame& frame) const {
  const HeldImages held{*backend_, {*references_[keyframe].pyramid, *current_}};
  return {keyframes_[keyframe], frame, gray_, camera_, options_.seed, frame_index_, expected, held};
}

std::optional<CoarseStart> KeyframeTracker::StartOf(int keyframe, const SE3d& expected,
                                                    const Frame& frame,
                                                    TrackedFrame* result) const {
  if (!initializer_) return std::nullopt;
  const Stopwatch watch(&result->times.initial_estimate_ms);
  return initializer_->StartOf(InputOf(keyframe, expected, frame));
}

// Those that are not there yet.
void KeyframeTracker::MakeIntensities(int keyframe, const Frame& frame, TrackedFrame* result) {
  const Stopwatch watch(&result->times.pyramid_ms);
  Image<float>& of_keyframe = keyframes_[keyframe].intensity;
  if (of_keyframe.empty()) of_keyframe = GrayFromRgb(keyframes_[keyframe].frame.rgb);
  if (gray_frame_index_ == frame_index_) return;
  GrayFromRgb(frame.rgb, &gray_);
  gray_frame_index_ = frame_index_;
}

std::unique_ptr<const CurrentPyramid> KeyframeTracker::MakeCurrent(const Frame& frame,
                                                                   TrackedFrame* result) const {
  const Stopwatch watch(&result->times.pyramid_ms);
  const AlignmentOptions& alignment = options_.alignment;
  const Image<float> none;
  return backend_->MakeCurrentOfColour(
      frame.rgb, alignment.use_current_depth ? frame.depth_m : none, alignment.Pyramids());
}

std::unique_ptr<ReferencePyramid> KeyframeTracker::MakeReference(const Frame& frame) const {
  const PyramidOptions pyramids = options_.alignment.Pyramids();
  if (current_) {
    auto made = backend_->MakeReferenceOfCurrent(*current_, frame.depth_m, camera_, pyramids);
    if (made) return made;
  }
  return backend_->MakeReferenceOfColour(frame.rgb, frame.depth_m, camera_, pyramids);
}

void KeyframeTracker::Refine(const KeyframeIds& nearest, const CurrentPyramid& current,
                             const SE3d& initial, TrackedFrame* result, const CoarseStart* first,
                             const Polish* last) {
  aligned_with_ = nearest;
  const SE3d anchor_from_world = keyframes_[nearest.front()].world_from_camera.Inverse();
  ReferenceViews views;
  for (const int id : nearest) {
    const Reference& reference = references_[id];
    views.push_back({*reference.pyramid, anchor_from_world * keyframes_[id].world_from_camera,
                     reference.content.edge_contrast});
  }
  views.front().anchor_from_reference = {};  // exactly
  result->alignment = Align(*backend_, views, current, initial, options_.alignment, first, last);
  AddTimes(result->alignment.times, &result->times);
  result->status = TrackingStatus::kLost;
  if (!result->alignment.ok) {
    result->message = "lost: " + result->alignment.failure;
    return;
  }
  result->evidence = EvidenceOf(*backend_, views, current, result->alignment,
                                references_[nearest.front()].content);
  const Judgement judgement = Judge(result->evidence, options_.trust);
  result->status = judgement.status;
  result->message = judgement.message;
}

bool KeyframeTracker::NeedsNewKeyframe(const TrackedFrame& result) const {
  if (keyframes_.empty()) return true;
  const bool trusted =
      result.status == TrackingStatus::kTracked ||
      (result.status == TrackingStatus::kDoubtful && !options_.keyframes.trusted_only);
  return trusted && (NeedsKeyframe(keyframes_, world_from_camera_, options_.keyframes) ||
                     ShowsWhatNoneKnows(world_from_camera_) || HasGoneStale(result));
}

bool KeyframeTracker::HasGoneStale(const TrackedFrame& result) const {
  const double unexplained = result.evidence.unexplained_variance;
  const double least = references_[result.keyframe_id].least_unexplained;
  return options_.keyframes.stale_share > 0 && unexplained > 2 * least &&
         unexplained >
             options_.keyframes.stale_share * options_.trust.doubtful_unexplained_variance;
}

void KeyframeTracker::RetireStale(const TrackedFrame& result) {
  if (keyframes_.empty() || !HasGoneStale(result)) return;
  for (const int id : aligned_with_) references_[id].stale = true;
}

// Nothing where it is not to be: it lets intensities count in full.
std::optional<Polish> KeyframeTracker::PolishOf(int keyframe, const Frame& frame,
                                                TrackedFrame* result) const {
  const ImageContent& content = references_[keyframe].content;
  if (options_.keyframes.polish_iterations == 0 ||
      options_.alignment.DoubtsColours(content.edge_contrast)) {
    return std::nullopt;
  }
  const Stopwatch watch(&result->times.pyramid_ms);
  Polish polish{options_.alignment, {}};
  polish.options.max_iterations = {options_.keyframes.polish_iterations};
  polish.options.min_update_norm /= 10;
  polish.pair = FullResolution(keyframe, frame, polish.options);
  return polish;
}

void KeyframeTracker::PolishPose(const Frame& frame, TrackedFrame* result) {
  if (keyframes_.empty()) return;
  std::shared_ptr<const AlignmentResult> polished = result->alignment.polished;
  if (!polished) {
    const std::optional<Polish> polish = PolishOf(result->keyframe_id, frame, result);
    if (!polish) return;
    polished = std::make_shared<const AlignmentResult>(
        Align(*backend_, polish->pair.images(), result->alignment.current_from_reference,
              polish->options));
    AddTimes(polished->times, &result->times);
  }
  if (!polished->ok) return;
  result->alignment = *polished;
  world_from_camera_ = PoseOf(result);
}

// Of what the backend holds of both images, if it holds all of it; else they are made anew.
OwnedPair KeyframeTracker::FullResolution(int keyframe, const Frame& frame,
                                          const AlignmentOptions& options) const {
  const PyramidOptions pyramids = options.Pyramids();
  if (current_ && backend_->halves_what_it_holds()) {
    return backend_->MakeHalved({*references_[keyframe].pyramid, *current_}, 0,
                                options.use_current_depth, pyramids);
  }
  const Frame& reference = keyframes_[keyframe].frame;
  const Image<float> none;
  return {backend_->MakeReferenceOfColour(reference.rgb, reference.depth_m, camera_, pyramids),
          backend_->MakeCurrentOfColour(frame.rgb, options.use_current_depth ? frame.depth_m : none,
                                        pyramids)};
}

// Of all the keyframes that the next frame could be aligned with, the camera sees too little.
bool KeyframeTracker::ShowsWhatNoneKnows(const SE3d& world_from_camera) const {
  if (options_.keyframes.min_overlap == 0) return false;
  const KeyframeIds nearest =
      NearestKeyframes(keyframes_, world_from_camera, options_.keyframes, options_.keyframes.joint);
  return std::none_of(nearest.begin(), nearest.end(), [&](int id) {
    return Overlap(keyframes_[id], world_from_camera) >= options_.keyframes.min_overlap;
  });
}

void KeyframeTracker::MakeKeyframe(const Given& given, TrackedFrame* result) {
  const Stopwatch watch(&result->times.pyramid_ms);
  const Frame& frame = given.frame;
  const ImageContent content = ContentOf(frame.rgb, frame.depth_m);
  const double measured = content.measured_share;
  if (measured < options_.keyframes.min_measured_depth || measured == 0) {
    result->message =
        "not a keyframe: " + std::to_string(int(100 * measured)) + " % of its depth is measured";
    return;
  }
  const int id = int(keyframes_.size());
  references_.push_back({MakeReference(frame), content, {}, tracked_from_});
  tracked_from_ = id;
  keyframes_.push_back({id, {}, {}, world_from_camera_, result->covariance});
  if (given.movable) {
    keyframes_.back().frame = std::move(*given.movable);
  } else {
    keyframes_.back().frame = frame;
  }
  result->new_keyframe = true;
  if (id == 0) {
    time_s_ = result->time_s;
    result->status = TrackingStatus::kTracked;
    result->keyframe_id = id;
  }
}

}  // namespace silt::tracker
