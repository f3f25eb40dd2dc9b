// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/block_alignments.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/cuda/block/block_backend.h"
#include "silt/tracker/trust.h"
#include "wavy_wall.h"

// Alignments that a machine runs from end to end, against those that come back for each step.
namespace silt::cuda {
namespace {

using tracker::AlignmentOptions;
using tracker::AlignmentResult;

bool SamePose(const SE3d& a, const SE3d& b) {
  return a.rotation.w == b.rotation.w && a.rotation.x == b.rotation.x &&
         a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z &&
         a.translation.x == b.translation.x && a.translation.y == b.translation.y &&
         a.translation.z == b.translation.z;
}

void ExpectSame(const AlignmentResult& a, const AlignmentResult& b) {
  EXPECT_EQ(a.ok, b.ok);
  EXPECT_EQ(a.failure, b.failure);
  EXPECT_TRUE(SamePose(a.current_from_reference, b.current_from_reference));
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.intensity_scale, b.intensity_scale);
  EXPECT_EQ(a.inverse_depth_scale, b.inverse_depth_scale);
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (std::size_t i = 0; i < a.levels.size(); ++i) {
    EXPECT_EQ(a.levels[i].level, b.levels[i].level);
    EXPECT_EQ(a.levels[i].width, b.levels[i].width);
    EXPECT_EQ(a.levels[i].iterations, b.levels[i].iterations);
    EXPECT_EQ(a.levels[i].converged, b.levels[i].converged);
    EXPECT_EQ(a.levels[i].initial_cost, b.levels[i].initial_cost);
    EXPECT_EQ(a.levels[i].final_cost, b.levels[i].final_cost);
  }
}

// A log makes the caller decide step by step.
AlignmentOptions StepByStep(AlignmentOptions options) {
  options.keep_log = true;
  return options;
}

std::vector<AlignmentOptions> AllOptions() {
  std::vector<AlignmentOptions> all{
      tracker::PaperPreset().alignment, tracker::PaperAllPixelsPreset().alignment,
      tracker::AccuratePreset().alignment, tracker::FastPreset().alignment};
  all.push_back(all[2]);
  all.back().depth_residual = false;
  all.push_back(all[0]);
  all.back().rotation_only = true;
  all.back().max_iterations = {0, 5, 0, 8};
  all.push_back(all[2]);
  all.back().max_iterations = {3, 3, 4, 5, 6, 7};
  return all;
}

class BlockAlignmentsOn : public BackendTest {};
INSTANTIATE_BACKENDS(BlockAlignmentsOn);

TEST_P(BlockAlignmentsOn, EndWhereStepsOneByOneEnd) {
  int aligned = 0;
  for (const AlignmentOptions& options : AllOptions()) {
    for (const bool with_depth : {true, false}) {
      const Pair pair = MakePair(*block_, options.Pyramids(), with_depth);
      for (const double start : {0.0, 0.7, 1.5}) {
        const SE3d initial = SE3d::Exp(start * kPose.Log());
        const AlignmentResult whole = tracker::Align(*block_, pair.images(), initial, options);
        EXPECT_TRUE(whole.log.empty());
        const AlignmentResult steps =
            tracker::Align(*block_, pair.images(), initial, StepByStep(options));
        EXPECT_EQ(steps.log.empty(), !steps.ok);
        aligned += steps.ok;
        ExpectSame(whole, steps);
      }
    }
  }
  EXPECT_GT(aligned, 30);
}

TEST_P(BlockAlignmentsOn, SeveralReferencesTogether) {
  for (const bool with_depth : {true, false}) {
    AlignmentOptions options = tracker::AccuratePreset().alignment;
    options.depth_residual = options.use_current_depth = with_depth;
    const Pair pair = MakePair(*block_, options.Pyramids(), with_depth);
    const SE3d anchor_from_other = SE3d::Exp({{0.01, 0.02, -0.01}, {-0.02, 0.03, 0.01}});
    const Pictures other = Scene(anchor_from_other.Inverse());
    const auto reference =
        block_->MakeReference(other.intensity, other.depth_m, kCamera, options.Pyramids());
    const tracker::ReferenceViews views{
        {*pair.reference, {}}, {*reference, anchor_from_other}, {*pair.reference, {}}};
    const AlignmentResult whole = tracker::Align(*block_, views, *pair.current, {}, options);
    ExpectSame(whole, tracker::Align(*block_, views, *pair.current, {}, StepByStep(options)));
    EXPECT_TRUE(whole.ok);
    EXPECT_LT(Norm((whole.current_from_reference * kPose.Inverse()).Log().v), 1e-3);
  }
}

TEST_P(BlockAlignmentsOn, JudgeWhatTheCallerWould) {
  const AlignmentOptions options = tracker::FastPreset().alignment;
  const Pair pair = MakePair(*block_, options.Pyramids());
  AlignmentResult whole = tracker::Align(*block_, pair.images(), {}, options);
  ASSERT_TRUE(whole.judged);
  const tracker::ReferenceViews views{{*pair.reference, {}}};
  const tracker::ImageContent content{1, 0.05, 0.5};
  const double on_the_way =
      tracker::EvidenceOf(*block_, views, *pair.current, whole, content).inlier_ratio;
  whole.judged.reset();
  EXPECT_EQ(tracker::EvidenceOf(*block_, views, *pair.current, whole, content).inlier_ratio,
            on_the_way);
  EXPECT_GT(on_the_way, 0.5);
  EXPECT_LT(on_the_way, 1);
}

// In one launch what two have found; nothing where the first fails; and its own failure where the
// second does.
TEST_P(BlockAlignmentsOn, AreFollowedByAPolish) {
  const AlignmentOptions options = tracker::FastPreset().alignment;
  const Pair pair = MakePair(*block_, options.Pyramids());
  tracker::Polish polish{options, {}};
  polish.options.max_iterations = {3};
  polish.pair = block_->MakeHalved(pair.images(), 0, true, polish.options.Pyramids());
  const tracker::ReferenceViews views{{*pair.reference, {}}};
  const auto align = [&](const SE3d& initial, const tracker::Polish* last) {
    return tracker::Align(*block_, views, *pair.current, initial, options, nullptr, last);
  };
  const AlignmentResult both = align({}, &polish), alone = align({}, nullptr);
  ExpectSame(both, alone);
  EXPECT_EQ(both.judged, alone.judged);
  EXPECT_FALSE(alone.polished);
  ASSERT_TRUE(both.polished);
  ExpectSame(*both.polished, tracker::Align(*block_, polish.pair.images(),
                                            alone.current_from_reference, polish.options));
  EXPECT_FALSE(SamePose(both.polished->current_from_reference, both.current_from_reference));
  const AlignmentResult lost = align(SE3d::Exp({{0, 2, 0}, {0, 0, 0}}), &polish);
  EXPECT_FALSE(lost.ok);
  EXPECT_FALSE(lost.polished);
  polish.options.min_overlap = 1;
  const AlignmentResult failing = align({}, &polish);
  EXPECT_TRUE(failing.ok);
  ASSERT_TRUE(failing.polished);
  EXPECT_FALSE(failing.polished->ok);
  polish.options.keep_log = true;  // for which it would have to go step by step
  EXPECT_FALSE(align({}, &polish).polished);
}

TEST_P(BlockAlignmentsOn, FailAsTheyWouldStepByStep) {
  const AlignmentOptions options = tracker::AccuratePreset().alignment;
  const Pair pair = MakePair(*block_, options.Pyramids());
  // Turned away; and nothing measured at all.
  const SE3d away = SE3d::Exp({{0, 2, 0}, {0, 0, 0}});
  const AlignmentResult lost = tracker::Align(*block_, pair.images(), away, options);
  EXPECT_FALSE(lost.ok);
  EXPECT_FALSE(lost.judged);
  ExpectSame(lost, tracker::Align(*block_, pair.images(), away, StepByStep(options)));
  const Pictures current = Scene(kPose);
  const auto blind =
      block_->MakeReference(current.intensity, Image<float>(kCamera.width, kCamera.height, 0.0f),
                            kCamera, options.Pyramids());
  const AlignmentResult none = tracker::Align(*block_, {*blind, *pair.current}, {}, options);
  EXPECT_EQ(none.failure, "no pyramid level has enough measured pixels");
}

// A line of pixels, none of which has four pixels around it.
TEST_P(BlockAlignmentsOn, FailWhereNoPixelCanBeCompared) {
  const PinholeCamera line{64, 64, 0, 31.5, 1, 64};
  AlignmentOptions options = tracker::PaperPreset().alignment;
  options.max_iterations = {5};
  options.exclude_hidden = false;
  const Image<float> intensity(1, 64, 0.5f), depth_m(1, 64, 1.0f);
  const auto reference = block_->MakeReference(intensity, depth_m, line, options.Pyramids());
  const auto current = block_->MakeCurrent(intensity, {}, options.Pyramids());
  const AlignmentResult result = tracker::Align(*block_, {*reference, *current}, {}, options);
  EXPECT_EQ(result.failure, "the images share 0 of 64 measured pixels at level 1");
}

// More starts than groups, of two pairs, good and bad.
TEST_P(BlockAlignmentsOn, ABatchFindsWhatEachOfItFinds) {
  for (AlignmentOptions options :
       {tracker::PaperPreset().alignment, tracker::FastPreset().alignment}) {
    options.max_iterations = {2, 3, 4, 5};
    const Pair pair = MakePair(*block_, options.Pyramids());
    const Pictures other = Scene(SE3d::Exp({{0, 0.02, 0}, {0, 0, 0.03}}));
    const auto reference =
        block_->MakeReference(other.intensity, other.depth_m, kCamera, options.Pyramids());
    const auto blind =
        block_->MakeReference(other.intensity, Image<float>(kCamera.width, kCamera.height, 0.0f),
                              kCamera, options.Pyramids());
    std::vector<tracker::AlignmentStart> starts;
    for (int i = 0; i < 13; ++i) {
      const tracker::ReferencePyramid& from = i == 7       ? *blind
                                              : i % 2 == 1 ? *pair.reference
                                                           : *reference;
      starts.push_back({from, *pair.current, SE3d::Exp(0.2 * i * kPose.Log())});
    }
    starts.back().initial = SE3d::Exp({{0, 2, 0}, {0, 0, 0}});
    const std::vector<AlignmentResult> batch = tracker::AlignBatch(*block_, starts, options);
    ASSERT_EQ(batch.size(), starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const auto& [from, current, initial] = starts[i];
      ExpectSame(batch[i], tracker::Align(*block_, {from, current}, initial, options));
    }
    EXPECT_TRUE(batch[3].ok && batch[10].ok);
    EXPECT_FALSE(batch[7].ok || batch[12].ok);
  }
}

// However starts of several pairs follow each other.
TEST(BlockAlignments, APairIsDescribedOnce) {
  const auto use = std::make_shared<MachineUse>();
  const auto backend = MakeEmulatedBackend(ThreadOrder::kForward, use);
  AlignmentOptions options = tracker::FastPreset().alignment;
  options.max_iterations = {0, 0, 0, 1};
  const Pair one = MakePair(*backend, options.Pyramids()),
             other = MakePair(*backend, options.Pyramids());
  std::vector<tracker::AlignmentStart> starts;
  for (int i = 0; i < 10; ++i) {
    const Pair& pair = i % 2 == 0 ? one : other;
    starts.push_back({*pair.reference, *pair.current, {}});
  }
  *use = {};
  tracker::AlignBatch(*backend, starts, options);
  EXPECT_EQ(use->uploaded_bytes,
            2 * sizeof(AlignTask) + 10 * sizeof(AlignStart) + 5 * sizeof(Round));
}

// Two groups of two blocks, on whatever side of a machine.
TEST_P(BlockAlignmentsOn, TwoTogetherFindWhatEachFinds) {
  for (const AlignmentOptions& options : AllOptions()) {
    for (const bool with_depth : {true, false}) {
      const Pair pair = MakePair(*block_, options.Pyramids(), with_depth);
      std::vector<tracker::AlignmentStart> starts;
      for (const double start : {0.3, 1.4}) {
        starts.push_back({*pair.reference, *pair.current, SE3d::Exp(start * kPose.Log())});
      }
      const std::vector<AlignmentResult> both = tracker::AlignBatch(*block_, starts, options);
      for (std::size_t i = 0; i < starts.size(); ++i) {
        ExpectSame(both[i], tracker::Align(*block_, pair.images(), starts[i].initial, options));
      }
    }
  }
}

// No thread reads in a phase what another one writes in it, nor a block what another one does.
TEST(BlockAlignments, TheOrderOfThreadsAndBlocksChangesNoBit) {
  const auto forward = MakeEmulatedBackend(ThreadOrder::kForward);
  const auto backward = MakeEmulatedBackend(ThreadOrder::kBackward);
  int aligned = 0;
  for (const AlignmentOptions& options : AllOptions()) {
    for (const bool with_depth : {true, false}) {
      const Pair one = MakePair(*forward, options.Pyramids(), with_depth);
      const Pair other = MakePair(*backward, options.Pyramids(), with_depth);
      const AlignmentResult result = tracker::Align(*forward, one.images(), {}, options);
      ExpectSame(result, tracker::Align(*backward, other.images(), {}, options));
      aligned += result.ok;
    }
  }
  EXPECT_GT(aligned, 10);
}

// A launch after the other: what a batch holds at once, however many starts it has.
TEST(BlockAlignments, MemoryDoesNotGrowWithTheStarts) {
  AlignmentOptions options = tracker::FastPreset().alignment;
  options.max_iterations = {0, 0, 0, 1};
  const auto held_at_most = [&](int count, int* launches) {
    const auto use = std::make_shared<MachineUse>();
    const auto backend = MakeEmulatedBackend(ThreadOrder::kForward, use);
    const Pair pair = MakePair(*backend, options.Pyramids());
    const std::size_t before = use->held_bytes;
    const std::vector<tracker::AlignmentStart> starts(
        std::size_t(count), tracker::AlignmentStart{*pair.reference, *pair.current, {}});
    EXPECT_EQ(tracker::AlignBatch(*backend, starts, options).size(), starts.size());
    EXPECT_EQ(use->held_bytes, before);
    *launches = use->group_launches;
    return use->most_held_bytes;
  };
  int few = 0, many = 0;
  EXPECT_EQ(held_at_most(10, &few), held_at_most(101, &many));
  EXPECT_EQ(few, 1);
  EXPECT_EQ(many, 11);
}

// A machine on which no block of an alignment can run.
struct FullMachine : HostMachine {
  FullMachine() : HostMachine(ThreadOrder::kForward) {}
  template <typename Body>
  int ResidentBlocks() const {
    return 0;
  }
};

TEST(BlockAlignments, ADeviceWithoutRoomForABlockIsAnError) {
  const BlockBackend<FullMachine> backend("full", FullMachine{});
  const AlignmentOptions options = tracker::FastPreset().alignment;
  const Pair pair = MakePair(backend, options.Pyramids());
  EXPECT_THROW(tracker::Align(backend, pair.images(), {}, options), Error);
}

TEST_P(BlockAlignmentsOn, ABatchOfNothingIsNothing) {
  EXPECT_TRUE(tracker::AlignBatch(*block_, {}, {}).empty());
}

}  // namespace
}  // namespace silt::cuda
