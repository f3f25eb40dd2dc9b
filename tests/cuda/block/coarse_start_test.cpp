// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "silt/core/pyramid.h"
#include "silt/tracker/coarse_initializer.h"
#include "wavy_wall.h"

// Coarse starts of images that a machine holds already, against those of images that it is given.
namespace silt::cuda {
namespace {

using tracker::CoarseInitializer;
using tracker::CoarseOptions;
using tracker::OwnedPair;

tracker::ResidualNorm Robust(bool use_depth) {
  tracker::ResidualNorm norm;
  norm.intensity = {8.0 / 255, 0.02, 1};
  norm.inverse_depth = {0, 0.01, 1};
  norm.use_depth = use_depth;
  return norm;
}

// Images that a machine holds, and what an initializer is given of them: no intensities.
struct HeldPair {
  explicit HeldPair(const tracker::Backend& machine)
      : backend(machine), pair(MakePair(machine, {4, 1, true})) {
    keyframe.frame.depth_m = Scene({}).depth_m;
  }
  tracker::InitializerInput From(const SE3d& expected) const {
    return {keyframe, frame, intensity, kCamera,
            0,        0,     expected,  tracker::HeldImages{backend, pair.images()}};
  }

  const tracker::Backend& backend;
  const Pair pair;
  tracker::Keyframe keyframe;
  const Frame frame;
  const Image<float> intensity;
};

class CoarseStartOn : public BackendTest {
 protected:
  // Edges left out of what is held come back.
  Pair Held(bool with_depth = true) const { return MakePair(*block_, {3, 2, true}, with_depth); }

  OwnedPair HalvedOnHost(int halvings, bool with_depth,
                         const tracker::PyramidOptions& options) const {
    Pictures reference = Scene({}), current = Scene(kPose);
    PinholeCamera camera = kCamera;
    for (int i = 0; i < halvings; ++i) {
      for (Pictures* pictures : {&reference, &current}) {
        *pictures = {HalvedIntensity(pictures->intensity), HalvedDepth(pictures->depth_m)};
      }
      camera = camera.Halved();
    }
    return {block_->MakeReference(reference.intensity, reference.depth_m, camera, options),
            block_->MakeCurrent(current.intensity, with_depth ? current.depth_m : Image<float>{},
                                options)};
  }

  // Without intensities where none are given.
  std::optional<SE3d> Estimate(std::shared_ptr<const tracker::Backend> backend,
                               const CoarseOptions& options, bool with_pictures,
                               const std::optional<tracker::HeldImages>& held) const {
    const Pictures reference = Scene({}), current = Scene(kPose);
    tracker::Keyframe keyframe;
    keyframe.frame.depth_m = reference.depth_m;
    Frame frame;
    Image<float> intensity;
    if (with_pictures) {
      keyframe.intensity = reference.intensity;
      frame.depth_m = current.depth_m;
      intensity = current.intensity;
    }
    return CoarseInitializer(std::move(backend), options)
        .Estimate({keyframe, frame, intensity, kCamera, 0, 0, {}, held})
        .current_from_keyframe;
  }
};
INSTANTIATE_BACKENDS(CoarseStartOn);

TEST_P(CoarseStartOn, SmallPicturesAreThoseOfTheHost) {
  const Pair held = Held();
  for (const int halvings : {0, 1, 2, 4}) {
    for (const int margin_px : {0, 1, 2}) {
      const bool with_depth = margin_px != 1 || halvings == 0;
      const tracker::PyramidOptions options{2, margin_px, with_depth};
      ASSERT_TRUE(block_->halves_what_it_holds());
      const OwnedPair halved = block_->MakeHalved(held.images(), halvings, with_depth, options);
      const OwnedPair wanted = HalvedOnHost(halvings, with_depth, options);
      EXPECT_EQ(halved.current->has_depth(), with_depth);
      ASSERT_EQ(halved.reference->levels().size(), 2u);
      for (int level = 0; level < options.levels; ++level) {
        const tracker::PyramidLevel &a = halved.reference->levels()[level],
                                    &b = wanted.reference->levels()[level];
        EXPECT_GT(a.measured_pixels, 0);
        EXPECT_EQ(a.measured_pixels, b.measured_pixels);
        EXPECT_EQ(a.camera.cx, b.camera.cx);
        EXPECT_EQ(block_->Linearize(halved.images(), level, kPose, Robust(with_depth)),
                  block_->Linearize(wanted.images(), level, kPose, Robust(with_depth)));
      }
    }
  }
}

TEST_P(CoarseStartOn, StartsAreThoseOfTheHostsPictures) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  const Pair pair = MakePair(*backend, {4, 1, true});
  for (CoarseOptions options : {tracker::TurnAlone(), tracker::WideStart()}) {
    for (tracker::AlignmentOptions& stage : options.stages) {
      for (int& iterations : stage.max_iterations) iterations = std::min(iterations, 4);
    }
    options.max_width = 80;
    const tracker::HeldImages held{*backend, pair.images()};
    const auto on_machine = Estimate(backend, options, false, held);
    const auto of_pictures = Estimate(backend, options, true, {});
    const auto cpu = Estimate(tracker::MakeCpuBackend(), options, true, held);
    ASSERT_TRUE(on_machine && of_pictures && cpu);
    EXPECT_EQ(on_machine->translation.x, of_pictures->translation.x);
    EXPECT_EQ(on_machine->rotation.x, of_pictures->rotation.x);
    EXPECT_LT(Norm((*on_machine * cpu->Inverse()).Log().v), 1e-5);
    EXPECT_LT(Norm((*on_machine * cpu->Inverse()).Log().omega), 1e-5);
    EXPECT_GT(Norm(cpu->rotation.Log()), 0.02);
  }
}

// Of many expected poses, all stages run together.
TEST_P(CoarseStartOn, ManyTogetherFindWhatEachFinds) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  const HeldPair held(*backend);
  CoarseOptions options = tracker::WideStart();
  for (tracker::AlignmentOptions& stage : options.stages) {
    for (int& iterations : stage.max_iterations) iterations = std::min(iterations, 3);
  }
  options.max_width = 80;
  const CoarseInitializer coarse(backend, options);
  std::vector<SE3d> expected;
  for (const double k : {0.0, 0.8, 1.5}) expected.push_back(SE3d::Exp(k * kPose.Log()));
  expected.push_back(SE3d::Exp({{0, 2.5, 0}, {0, 0, 0}}));  // sees nothing of it
  const auto all = coarse.FindFrom(held.From({}), expected);
  ASSERT_EQ(all.size(), expected.size());
  int found = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto one =
        CoarseInitializer(backend, options).Estimate(held.From(expected[i])).current_from_keyframe;
    ASSERT_EQ(all[i].has_value(), one.has_value()) << i;
    if (!one) continue;
    ++found;
    EXPECT_EQ(all[i]->translation.x, one->translation.x);
    EXPECT_EQ(all[i]->rotation.y, one->rotation.y);
  }
  EXPECT_GE(found, 1);
  EXPECT_FALSE(all.back());
}

void ExpectSamePose(const SE3d& a, const SE3d& b) {
  EXPECT_EQ(a.translation.x, b.translation.x);
  EXPECT_EQ(a.translation.z, b.translation.z);
  EXPECT_EQ(a.rotation.x, b.rotation.x);
  EXPECT_EQ(a.rotation.z, b.rotation.z);
}

CoarseOptions TwoStages(int max_width) {
  CoarseOptions options = tracker::WideStart();
  options.turns_rad = {{}};
  options.max_width = max_width;
  for (tracker::AlignmentOptions& stage : options.stages) {
    for (int& iterations : stage.max_iterations) iterations = std::min(iterations, 4);
  }
  return options;
}

// What it finds at its coarsest level alone, finer ones like less than the truth.
CoarseOptions CoarsestAlone() {
  CoarseOptions options = TwoStages(80);
  options.stages.resize(1);
  options.stages[0].max_iterations = {0, 0, 4};
  return options;
}

// After a stage that moves the pose, none that is ever content.
CoarseOptions WithoutEnd() {
  CoarseOptions options = TwoStages(80);
  options.stages[1].min_overlap = 1;
  return options;
}

// From stage to stage on the machine, from there to the comparison and on to the refinement: as
// where the host asks for each of them.
TEST_P(CoarseStartOn, RunsTogetherWithTheRefinement) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  const HeldPair held(*backend);
  const tracker::AlignmentOptions refinement = tracker::FastPreset().alignment;
  tracker::AlignmentOptions step_by_step = refinement;
  step_by_step.keep_log = true;
  const SE3d away = SE3d::Exp({{0, 2.5, 0}, {0, 0, 0}});  // sees nothing of it: no stage ends
  int found = 0, kept = 0;
  for (const CoarseOptions& options :
       {tracker::TurnAlone(), TwoStages(80), CoarsestAlone(), WithoutEnd()}) {
    CoarseInitializer coarse(backend, options);
    for (const SE3d& expected : {SE3d{}, SE3d::Exp(0.6 * kPose.Log()), kPose, away}) {
      const tracker::InitializerInput input = held.From(expected);
      const auto start = coarse.StartOf(input);
      ASSERT_TRUE(start);
      const tracker::ReferenceViews views{{*held.pair.reference, {}}};
      const tracker::AlignmentResult whole =
          tracker::Align(*backend, views, *held.pair.current, expected, refinement, &*start);
      const tracker::AlignmentResult steps =
          tracker::Align(*backend, views, *held.pair.current, expected, step_by_step, &*start);
      const std::optional<SE3d> estimate = coarse.Estimate(input).current_from_keyframe;
      ASSERT_EQ(whole.coarse.has_value(), estimate.has_value());
      ASSERT_EQ(steps.coarse.has_value(), estimate.has_value());
      if (estimate) ExpectSamePose(*whole.coarse, *estimate);
      if (estimate) ExpectSamePose(*steps.coarse, *estimate);
      ExpectSamePose(whole.current_from_reference, steps.current_from_reference);
      const tracker::AlignmentResult apart =
          tracker::Align(*backend, held.pair.images(), estimate.value_or(expected), refinement);
      EXPECT_EQ(whole.ok, apart.ok);
      EXPECT_EQ(whole.ok, Norm((whole.current_from_reference * kPose.Inverse()).Log().v) < 0.01);
      ExpectSamePose(whole.current_from_reference, apart.current_from_reference);
      EXPECT_EQ(whole.judged, apart.judged);
      ++(estimate ? found : kept);
    }
  }
  EXPECT_GE(found, 6);
  EXPECT_GE(kept, 4 + 4);  // where it looks away, and without an end
}

TEST_P(CoarseStartOn, RunsTogetherFromOnePlaceAlone) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  const HeldPair held(*backend);
  const tracker::InitializerInput input = held.From({});
  EXPECT_TRUE(CoarseInitializer(backend, tracker::TurnAlone()).StartOf(input));
  EXPECT_FALSE(CoarseInitializer(backend, tracker::WideStart()).StartOf(input));
  const tracker::InitializerInput elsewhere{held.keyframe, held.frame, held.intensity, kCamera};
  EXPECT_FALSE(CoarseInitializer(backend, tracker::TurnAlone()).StartOf(elsewhere));
}

TEST_P(CoarseStartOn, OnlyWhatIsHeldElsewhereNeedsIntensities) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  const CoarseInitializer coarse(backend, tracker::TurnAlone());
  EXPECT_FALSE(coarse.needs_intensities(*backend));
  EXPECT_TRUE(coarse.needs_intensities(*cpu_));
  struct Features : tracker::Initializer {
    tracker::InitialEstimate Estimate(const tracker::InitializerInput&) override { return {}; }
  };
  const CoarseInitializer both(backend, tracker::TurnAlone(), std::make_unique<Features>());
  EXPECT_TRUE(both.needs_intensities(*backend));
  const CoarseInitializer on_cpu(tracker::MakeCpuBackend(), tracker::TurnAlone());
  EXPECT_TRUE(on_cpu.needs_intensities(*backend));
}

}  // namespace
}  // namespace silt::cuda
