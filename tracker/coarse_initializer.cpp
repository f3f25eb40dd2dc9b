// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/coarse_initializer.h"

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

SmallPair Halved(const InitializerInput& input, int max_width) {
  SmallPair pair{input.camera,
                 {input.keyframe.intensity, input.keyframe.frame.depth_m},
                 {input.intensity, input.current.depth_m}};
  while (pair.camera.width > max_width) {
    pair.keyframe.Halve();
    pair.current.Halve();
    pair.camera = pair.camera.Halved();
  }
  return pair;
}

// A pair of small pictures made ready for one stage.
class Stage {
 public:
  Stage(const Backend& backend, const SmallPair& pair, const AlignmentOptions& options)
      : backend_(backend),
        options_(options),
        reference_(backend.MakeReference(pair.keyframe.intensity, pair.keyframe.depth_m,
                                         pair.camera, options.Pyramids())),
        current_(
            backend.MakeCurrent(pair.current.intensity,
                                options.use_current_depth ? pair.current.depth_m : Image<float>{},
                                options.Pyramids())) {}

  // Of the starts, the one that ends with pictures most alike; the first of equals.
  AlignmentResult BestFrom(const std::vector<SE3d>& starts) const {
    AlignmentResult best;
    for (const SE3d& start : starts) {
      AlignmentResult result = Align(backend_, {*reference_, *current_}, start, options_);
      const bool better = result.ok && (!best.ok || result.final_cost().mean_square() <
                                                        best.final_cost().mean_square());
      if (better) best = std::move(result);
    }
    return best;
  }

 private:
  const Backend& backend_;
  const AlignmentOptions& options_;
  std::unique_ptr<const ReferencePyramid> reference_;
  std::unique_ptr<const CurrentPyramid> current_;
};

// Mean r² of the intensities of the small pictures, or nothing where they share no pixels.
std::optional<double> Difference(const Backend& backend, const SmallPair& pair, const SE3d& pose) {
  const auto reference =
      backend.MakeReference(pair.keyframe.intensity, pair.keyframe.depth_m, pair.camera, {1});
  const auto current = backend.MakeCurrent(pair.current.intensity, {}, {1});
  const PhotometricCost cost = backend.Cost({*reference, *current}, 0, pose);
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

CoarseInitializer::CoarseInitializer(std::unique_ptr<const Backend> backend,
                                     const CoarseOptions& options,
                                     std::unique_ptr<Initializer> other)
    : backend_(std::move(backend)), options_(options), other_(std::move(other)) {
  SILT_CHECK(backend_ != nullptr);
  options_.Validate();
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
  const SmallPair pair = Halved(input, options_.max_width);
  if (pair.camera.width < kSmallestSide || pair.camera.height < kSmallestSide) return {};
  std::vector<SE3d> starts;
  if (other) starts.push_back(*other);
  for (const Vec3d& turn : options_.turns_rad) {
    starts.push_back(SE3d{Quaterniond::Exp(turn), {}} * input.expected);
  }
  for (const AlignmentOptions& stage : options_.stages) {
    const AlignmentResult result = Stage(*backend_, pair, stage).BestFrom(starts);
    if (!result.ok) return {};
    starts = {result.current_from_reference};
  }
  const std::optional<double> before = Difference(*backend_, pair, input.expected);
  const std::optional<double> after = Difference(*backend_, pair, starts.front());
  if (!after || (before && *after >= *before)) return {};
  return starts.front();
}

}  // namespace silt::tracker
