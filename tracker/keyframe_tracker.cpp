// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe_tracker.h"

#include <algorithm>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/stopwatch.h"

namespace silt::tracker {
namespace {

void CheckSize(const char* what, int width, int height, const PinholeCamera& camera, int frame) {
  if (width == camera.width && height == camera.height) return;
  throw Error("frame " + std::to_string(frame) + ": its " + what + " has " + std::to_string(width) +
              "x" + std::to_string(height) + " pixels and the camera " +
              std::to_string(camera.width) + "x" + std::to_string(camera.height) +
              "; give images of the camera's size");
}

// What a keyframe's images are like.
struct ImageFacts {
  double measured = 0;          // pixels with a depth
  double inverse_depths = 0;    // their sum, 1/m
  double sum = 0, squares = 0;  // of the intensity

  ImageFacts& operator+=(const ImageFacts& other) {
    measured += other.measured;
    inverse_depths += other.inverse_depths;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
};

// Several sums side by side, so that no addition waits for the one before it.
ImageFacts FactsOfRow(const float* intensity, const float* depth_m, int width) {
  constexpr int kSums = 8;
  ImageFacts sums[kSums], total;
  for (int x = 0; x < width; ++x) {
    ImageFacts& facts = sums[x % kSums];
    const bool measured = IsMeasured(depth_m[x]);
    facts.measured += measured ? 1 : 0;
    facts.inverse_depths += measured ? 1 / double(depth_m[x]) : 0;
    facts.sum += double(intensity[x]);
    facts.squares += double(intensity[x]) * double(intensity[x]);
  }
  for (const ImageFacts& facts : sums) total += facts;
  return total;
}

// Row by row in parallel, then the rows in order.
ImageFacts FactsOf(const Image<float>& intensity, const Image<float>& depth_m) {
  std::vector<ImageFacts> rows(std::size_t(intensity.height()));
  ParallelFor(intensity.height(), [&](int y) {
    rows[std::size_t(y)] = FactsOfRow(intensity.row(y), depth_m.row(y), intensity.width());
  });
  ImageFacts total;
  for (const ImageFacts& row : rows) total += row;
  return total;
}

double MeanInverseDepth(const ImageFacts& facts) {
  return facts.measured > 0 ? facts.inverse_depths / facts.measured : 0;
}

double Variance(const ImageFacts& facts, double pixels) {
  const double mean = facts.sum / pixels;
  return std::max(0.0, facts.squares / pixels - mean * mean);
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
}

KeyframeTracker::~KeyframeTracker() = default;

TrackedFrame KeyframeTracker::Track(const Frame& frame,
                                    const std::optional<SE3d>& expected_world_from_camera) {
  CheckFrame(frame);
  TrackedFrame result;
  result.time_s = frame.time_s;
  {
    const Stopwatch total(&result.times.total_ms);
    MakeGray(frame, &result);
    // The first frame is the first keyframe; later ones are aligned with the nearest keyframe.
    if (!keyframes_.empty()) {
      const SE3d expected = expected_world_from_camera.value_or(Predicted(frame.time_s));
      Localize(frame, gray_, expected, &result);
    }
    if (NeedsNewKeyframe(result)) MakeKeyframe(frame, &result);
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

void KeyframeTracker::MakeGray(const Frame& frame, TrackedFrame* result) {
  const Stopwatch watch(&result->times.pyramid_ms);
  GrayFromRgb(frame.rgb, &gray_);
}

void KeyframeTracker::Localize(const Frame& frame, const Image<float>& intensity,
                               const SE3d& expected, TrackedFrame* result) {
  // The position of the previous image defines the nearest keyframe (§3.1).
  const std::vector<int> nearest =
      NearestKeyframes(keyframes_, options_.always_initialize ? world_from_camera_ : expected,
                       options_.keyframes, options_.keyframes.joint);
  const Keyframe& keyframe = keyframes_[nearest.front()];
  result->keyframe_id = keyframe.id;
  const std::unique_ptr<CurrentPyramid> current = MakeCurrent(frame, intensity, result);
  // Initial T_cr (§3.2), then its refinement (§3.3).
  const SE3d start = expected.Inverse() * keyframe.world_from_camera;
  if (options_.always_initialize) Initialize(keyframe, start, frame, intensity, result);
  Refine(nearest, *current, result->initial.current_from_keyframe.value_or(start), result);
  if (result->status != TrackingStatus::kTracked && !options_.always_initialize &&
      Initialize(keyframe, start, frame, intensity, result)) {
    Refine(nearest, *current, *result->initial.current_from_keyframe, result);
  }
  if (result->status != TrackingStatus::kTracked) {
    velocity_.reset();
    return;
  }
  // T_wc = T_w,near · T_near,c.
  Accept(keyframe.world_from_camera * result->alignment.current_from_reference.Inverse(),
         frame.time_s);
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

void KeyframeTracker::Accept(const SE3d& world_from_camera, double time_s) {
  const double dt_s = time_s - time_s_;
  velocity_.reset();
  if (dt_s > 0) {
    const Twistd moved = (world_from_camera_.Inverse() * world_from_camera).Log();
    velocity_ = Twistd{1 / dt_s * moved.omega, 1 / dt_s * moved.v};
  }
  world_from_camera_ = world_from_camera;
  time_s_ = time_s;
}

bool KeyframeTracker::Initialize(const Keyframe& nearest, const SE3d& expected, const Frame& frame,
                                 const Image<float>& intensity, TrackedFrame* result) {
  if (!initializer_) return false;
  const Stopwatch watch(&result->times.initial_estimate_ms);
  result->initial = initializer_->Estimate(
      {nearest, frame, intensity, camera_, options_.seed, frame_index_, expected});
  return result->initial.current_from_keyframe.has_value();
}

std::unique_ptr<CurrentPyramid> KeyframeTracker::MakeCurrent(const Frame& frame,
                                                             const Image<float>& intensity,
                                                             TrackedFrame* result) const {
  const Stopwatch watch(&result->times.pyramid_ms);
  const AlignmentOptions& alignment = options_.alignment;
  const Image<float> none;
  return backend_->MakeCurrent(intensity, alignment.use_current_depth ? frame.depth_m : none,
                               alignment.Pyramids());
}

void KeyframeTracker::Refine(const std::vector<int>& nearest, const CurrentPyramid& current,
                             const SE3d& initial, TrackedFrame* result) {
  const SE3d anchor_from_world = keyframes_[nearest.front()].world_from_camera.Inverse();
  std::vector<ReferenceView> views;
  for (const int id : nearest) {
    views.push_back(
        {*references_[id].pyramid, anchor_from_world * keyframes_[id].world_from_camera});
  }
  views.front().anchor_from_reference = {};  // exactly
  result->alignment = Align(*backend_, views, current, initial, options_.alignment);
  result->times.residual_ms += result->alignment.times.residual_ms;
  result->times.jacobian_ms += result->alignment.times.jacobian_ms;
  result->times.update_ms += result->alignment.times.update_ms;
  Judge(references_[nearest.front()], result);
}

void KeyframeTracker::Judge(const Reference& reference, TrackedFrame* result) const {
  const double left = result->alignment.final_cost().mean_square();
  if (!result->alignment.ok) {
    result->message = "lost: " + result->alignment.failure;
  } else if (left > options_.max_unexplained_variance * reference.variance) {
    result->message = "lost: the aligned images do not look alike";
  } else if (result->alignment.inverse_depth_scale >
             options_.max_depth_disagreement * reference.mean_inverse_depth) {
    result->message = "lost: the aligned depths differ";
  } else {
    result->status = TrackingStatus::kTracked;
  }
}

bool KeyframeTracker::NeedsNewKeyframe(const TrackedFrame& result) const {
  if (keyframes_.empty()) return true;
  return result.status == TrackingStatus::kTracked &&
         NeedsKeyframe(keyframes_, world_from_camera_, options_.keyframes);
}

void KeyframeTracker::MakeKeyframe(const Frame& frame, TrackedFrame* result) {
  const Stopwatch watch(&result->times.pyramid_ms);
  const ImageFacts facts = frame.depth_m.empty() ? ImageFacts{} : FactsOf(gray_, frame.depth_m);
  const double pixels = std::max(1.0, double(gray_.size()));
  const double measured = facts.measured / pixels;
  if (measured < options_.keyframes.min_measured_depth || measured == 0) {
    result->message =
        "not a keyframe: " + std::to_string(int(100 * measured)) + " % of its depth is measured";
    return;
  }
  const int id = int(keyframes_.size());
  references_.push_back(
      {backend_->MakeReference(gray_, frame.depth_m, camera_, options_.alignment.Pyramids()),
       Variance(facts, pixels), MeanInverseDepth(facts)});
  keyframes_.push_back({id, frame, std::move(gray_), world_from_camera_});
  gray_ = {};
  result->new_keyframe = true;
  if (id == 0) {
    time_s_ = frame.time_s;
    result->status = TrackingStatus::kTracked;
    result->keyframe_id = id;
  }
}

}  // namespace silt::tracker
