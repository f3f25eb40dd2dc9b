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

// A place to look for the pose from, and where the search has come to: nowhere once it has failed.
struct Search {
  SE3d expected;
  std::vector<SE3d> starts;
};

// Aligns from all starts of all searches at once. Of a search's, the one stays that ends with
// pictures most alike; the first of equals.
void RunStage(const Backend& backend, const OwnedPair& pair, const AlignmentOptions& options,
              std::vector<Search>* searches) {
  std::vector<AlignmentStart> all;
  for (const Search& search : *searches) {
    for (const SE3d& start : search.starts) all.push_back({*pair.reference, *pair.current, start});
  }
  const std::vector<AlignmentResult> results = AlignBatch(backend, all, options);
  auto result = results.begin();
  for (Search& search : *searches) {
    const AlignmentResult* best = nullptr;
    for (std::size_t i = 0; i < search.starts.size(); ++i, ++result) {
      const bool better = result->ok && (!best || result->final_cost().mean_square() <
                                                      best->final_cost().mean_square());
      if (better) best = &*result;
    }
    search.starts.clear();
    if (best) search.starts.push_back(best->current_from_reference);
  }
}

// Those of the searches' ends that make the small pictures more alike than the expected pose does:
// by the mean r² of their intensities, where they share any pixels.
std::vector<std::optional<SE3d>> MoreAlike(const Backend& backend, const OwnedPair& pair,
                                           const std::vector<Search>& searches) {
  std::vector<SE3d> poses;
  for (const Search& search : searches) {
    if (search.starts.empty()) continue;
    poses.push_back(search.expected);
    poses.push_back(search.starts.front());
  }
  const std::vector<PhotometricCost> costs = backend.Costs(pair.images(), 0, poses);
  std::vector<std::optional<SE3d>> found(searches.size());
  auto cost = costs.begin();
  for (std::size_t i = 0; i < searches.size(); ++i) {
    if (searches[i].starts.empty()) continue;
    const PhotometricCost &before = *cost++, &after = *cost++;
    if (IsMoreAlike(after, before)) found[i] = searches[i].starts.front();
  }
  return found;
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
    const std::optional<SE3d> found =
        Find(input, {input.expected}, estimate.current_from_keyframe).front();
    if (found) estimate.current_from_keyframe = found;
  }
  return estimate;
}

std::vector<std::optional<SE3d>> CoarseInitializer::FindFrom(
    const InitializerInput& input, const std::vector<SE3d>& expected) const {
  return Find(input, expected, {});
}

std::optional<int> CoarseInitializer::Halvings(const InitializerInput& input) const {
  if (input.keyframe.frame.depth_m.empty()) return std::nullopt;
  PinholeCamera camera = input.camera;
  int halvings = 0;
  for (; camera.width > options_.max_width; camera = camera.Halved()) ++halvings;
  if (camera.width < kSmallestSide || camera.height < kSmallestSide) return std::nullopt;
  return halvings;
}

std::optional<CoarseStart> CoarseInitializer::StartOf(const InitializerInput& input) const {
  const std::vector<Vec3d>& turns = options_.turns_rad;
  const bool one = turns.size() == 1 && Norm(turns.front()) == 0 && !other_;
  const bool held = input.held && HalvesWhatIsHeldBy(input.held->backend);
  if (!one || !held || !backend_->runs_alignments()) return std::nullopt;
  const std::optional<int> halvings = Halvings(input);
  if (!halvings) return std::nullopt;
  const MakeSmall make = FromHeld(*input.held, *halvings);
  CoarseStart start;
  for (const AlignmentOptions& stage : options_.stages) {
    start.stages.push_back({stage, make(stage.use_current_depth, stage.Pyramids())});
  }
  start.compared = make(false, {1});
  return start;
}

std::vector<std::optional<SE3d>> CoarseInitializer::Find(const InitializerInput& input,
                                                         const std::vector<SE3d>& expected,
                                                         const std::optional<SE3d>& other) const {
  const std::optional<int> found = Halvings(input);
  if (!found) return std::vector<std::optional<SE3d>>(expected.size());
  const int halvings = *found;
  const bool held = input.held && HalvesWhatIsHeldBy(input.held->backend);
  const MakeSmall make =
      held ? FromHeld(*input.held, halvings) : FromHost(*backend_, Halved(input, halvings));
  std::vector<Search> searches;
  for (const SE3d& pose : expected) {
    searches.push_back({pose, {}});
    std::vector<SE3d>& starts = searches.back().starts;
    if (other) starts.push_back(*other);
    for (const Vec3d& turn : options_.turns_rad) {
      starts.push_back(SE3d{Quaterniond::Exp(turn), {}} * pose);
    }
  }
  for (const AlignmentOptions& stage : options_.stages) {
    RunStage(*backend_, make(stage.use_current_depth, stage.Pyramids()), stage, &searches);
  }
  return MoreAlike(*backend_, make(false, {1}), searches);
}

}  // namespace silt::tracker
