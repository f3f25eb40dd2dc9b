// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/coarse_initializer.h"

#include <functional>
#include <numbers>
#include <optional>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/stopwatch.h"

namespace silt::tracker {
namespace {

// A picture of less than this many pixels a side shows nothing.
constexpr int kSmallestSide = 8;

// What the stages align; a frame's depth may be missing.
struct SmallPicture {
  Image<float> intensity, depth_m;

  void Halve() {
    intensity = HalvedIntensity(intensity);
    if (!depth_m.empty()) depth_m = HalvedDepth(depth_m);
  }
};

struct SmallPair {
  PinholeCamera camera;
  SmallPicture keyframe, current;
};

SmallPair Halved(const InitializerInput& input, int halvings) {
  SmallPair pair{input.camera,
                 {input.keyframe.intensity, input.keyframe.frame.depth_m},
                 {input.intensity, input.current.depth_m}};
  for (int i = 0; i < halvings; ++i) {
    pair.keyframe.Halve();
    pair.current.Halve();
    pair.camera = pair.camera.Halved();
  }
  return pair;
}

// Makes pyramids of small pictures, with the current depth if asked for.
using MakeSmall = std::function<OwnedPair(bool with_depth, const PyramidOptions&)>;

MakeSmall FromHeld(const HeldImages& held, int halvings) {
  return [held, halvings](bool with_depth, const PyramidOptions& options) {
    return held.backend.MakeHalved(held.images, halvings, with_depth, options);
  };
}

MakeSmall FromHost(const Backend& backend, SmallPair pair) {
  return [&backend, pair = std::move(pair)](bool with_depth, const PyramidOptions& options) {
    const auto& [camera, keyframe, current] = pair;
    return OwnedPair{backend.MakeReference(keyframe.intensity, keyframe.depth_m, camera, options),
                     backend.MakeCurrent(current.intensity,
                                         with_depth ? current.depth_m : Image<float>{}, options)};
  };
}

// Of the starts, the one that ends with pictures most alike; the first of equals.
AlignmentResult BestFrom(const std::vector<SE3d>& starts, const Backend& backend,
                         const OwnedPair& pair, const AlignmentOptions& options) {
  std::vector<AlignmentStart> all;
  for (const SE3d& start : starts) all.push_back({*pair.reference, *pair.current, start});
  AlignmentResult best;
  for (AlignmentResult& result : AlignBatch(backend, all, options)) {
    const bool better = result.ok && (!best.ok || result.final_cost().mean_square() <
                                                      best.final_cost().mean_square());
    if (better) best = std::move(result);
  }
  return best;
}

// Mean r² of the intensities of the small pictures, or nothing where they share no pixels.
std::optional<double> Difference(const Backend& backend, const OwnedPair& pair, const SE3d& pose) {
  const PhotometricCost cost = backend.Cost(pair.images(), 0, pose);
  if (cost.pixels == 0) return {};
  return cost.mean_square();
}

}  // namespace

void CoarseOptions::Validate() const {
  if (max_width < kSmallestSide) throw Error("coarse start: max_width must be at least 8");
  if (stages.empty()) throw Error("coarse start: give at least one stage");
  if (turns_rad.empty()) throw Error("coarse start: give at least one turn, if none at all");
  for (const AlignmentOptions& stage : stages) stage.Validate();
}

CoarseOptions TurnAlone() {
  AlignmentOptions stage;
  stage.max_iterations = {20, 20, 20};
  stage.rotation_only = true;
  stage.exclude_hidden = false;
  stage.min_overlap = 0.2;
  stage.min_update_norm = 1e-4;
  return {80, {stage}};
}

CoarseOptions WideStart() {
  AlignmentOptions search = AccuratePreset().alignment;
  search.depth_edge_margin_px = 0;
  search.exclude_hidden = false;
  search.min_update_norm = 1e-4;
  AlignmentOptions polish = search;
  search.max_iterations = {0, 0, 20, 30, 30};
  polish.max_iterations = {5, 10};
  constexpr double turn = 8 * std::numbers::pi / 180;
  return {160, {search, polish}, {{}, {turn, 0, 0}, {-turn, 0, 0}, {0, turn, 0}, {0, -turn, 0}}};
}

CoarseInitializer::CoarseInitializer(std::shared_ptr<const Backend> backend,
                                     const CoarseOptions& options,
                                     std::unique_ptr<Initializer> other)
    : backend_(std::move(backend)), options_(options), other_(std::move(other)) {
  SILT_CHECK(backend_ != nullptr);
  options_.Validate();
}

bool CoarseInitializer::HalvesWhatIsHeldBy(const Backend& backend) const {
  return &backend == backend_.get() && backend.halves_what_it_holds();
}

bool CoarseInitializer::needs_intensities(const Backend& backend) const {
  return !HalvesWhatIsHeldBy(backend) || (other_ && other_->needs_intensities(backend));
}

InitialEstimate CoarseInitializer::Estimate(const InitializerInput& input) {
  InitialEstimate estimate;
  if (other_) estimate = other_->Estimate(input);
  {
    const Stopwatch watch(&estimate.milliseconds);
    const std::optional<SE3d> found = Find(input, estimate.current_from_keyframe);
    if (found) estimate.current_from_keyframe = found;
  }
  return estimate;
}

std::optional<SE3d> CoarseInitializer::Find(const InitializerInput& input,
                                            const std::optional<SE3d>& other) const {
  if (input.keyframe.frame.depth_m.empty()) return {};
  PinholeCamera camera = input.camera;
  int halvings = 0;
  for (; camera.width > options_.max_width; camera = camera.Halved()) ++halvings;
  if (camera.width < kSmallestSide || camera.height < kSmallestSide) return {};
  const bool held = input.held && HalvesWhatIsHeldBy(input.held->backend);
  const MakeSmall make =
      held ? FromHeld(*input.held, halvings) : FromHost(*backend_, Halved(input, halvings));
  std::vector<SE3d> starts;
  if (other) starts.push_back(*other);
  for (const Vec3d& turn : options_.turns_rad) {
    starts.push_back(SE3d{Quaterniond::Exp(turn), {}} * input.expected);
  }
  for (const AlignmentOptions& stage : options_.stages) {
    const OwnedPair pair = make(stage.use_current_depth, stage.Pyramids());
    const AlignmentResult result = BestFrom(starts, *backend_, pair, stage);
    if (!result.ok) return {};
    starts = {result.current_from_reference};
  }
  const OwnedPair plain = make(false, {1});
  const std::optional<double> before = Difference(*backend_, plain, input.expected);
  const std::optional<double> after = Difference(*backend_, plain, starts.front());
  if (!after || (before && *after >= *before)) return {};
  return starts.front();
}

}  // namespace silt::tracker
