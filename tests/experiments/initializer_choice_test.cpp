// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initializer_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/experiments/tracking_run.h"
#include "silt/tracker/coarse_initializer.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

std::string Complaint(const std::string& text) {
  try {
    ParseInitializer(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(InitializerChoice, KnowsEveryNameAndNoOther) {
  for (const std::string& name : InitializerNames()) {
    EXPECT_EQ(ParseInitializer(name).kind, name);
  }
  EXPECT_THAT(Complaint("guess"), HasSubstr("'guess'; there are: auto, identity, previous"));
  EXPECT_NE(Complaint(""), "");
  EXPECT_EQ(ParseInitializer("sparse").kind, "auto");
}

TEST(InitializerChoice, ReadsThePerturbationOfTheTruth) {
  const InitializerChoice choice = ParseInitializer("truth:0.02m,1.5deg");
  EXPECT_TRUE(choice.uses_truth());
  EXPECT_EQ(choice.perturbation.distance_m, 0.02);
  EXPECT_EQ(choice.perturbation.angle_deg, 1.5);
  EXPECT_EQ(ParseInitializer("truth").perturbation.angle_deg, 0);
  for (const char* wrong : {"truth:", "truth:1m", "truth:1m,2", "truth:2deg,1m", "truth:-1m,1deg",
                            "truth:nanm,1deg", "truth:1m,1deg,", "surf:0.02m,1deg"}) {
    EXPECT_THAT(Complaint(wrong), HasSubstr("truth:0.02m,1deg")) << wrong;
  }
}

TEST(InitializerChoice, MakesAnInitializerWhereOneIsNeeded) {
  for (const char* name : {"auto", "rotation", "surf", "sift", "orb", "akaze"}) {
    EXPECT_NE(MakeInitializer(ParseInitializer(name)), nullptr) << name;
  }
  for (const char* name : {"identity", "previous", "constant-velocity", "truth"}) {
    EXPECT_EQ(MakeInitializer(ParseInitializer(name)), nullptr) << name;
  }
}

TEST(InitializerChoice, StartsAPresetWideThatInitializesOnlyWhereItIsLost) {
  const auto automatic = [](const tracker::TrackerOptions& preset) {
    return MakeInitializer(ParseInitializer("auto"), preset);
  };
  const auto is_wide = [](const std::unique_ptr<tracker::Initializer>& initializer) {
    return dynamic_cast<const tracker::CoarseInitializer*>(initializer.get()) != nullptr;
  };
  EXPECT_FALSE(is_wide(automatic(tracker::PaperPreset())));
  EXPECT_TRUE(is_wide(automatic(tracker::AccuratePreset())));
  EXPECT_TRUE(is_wide(automatic(tracker::FastPreset())));
}

TEST(InitializerChoice, LeavesAPresetAsItIsUnlessAsked) {
  const tracker::TrackerOptions fast = tracker::FastPreset();
  const auto with = [&](const char* name) { return WithInitializer(fast, ParseInitializer(name)); };
  EXPECT_FALSE(with("auto").always_initialize);
  EXPECT_EQ(with("auto").start, tracker::Start::kConstantVelocity);
  EXPECT_TRUE(with("orb").always_initialize);
  EXPECT_EQ(with("identity").start, tracker::Start::kKeyframe);
  EXPECT_EQ(with("previous").start, tracker::Start::kPrevious);
}

TEST(PerturbedTruth, IsAsFarFromTheTruthAsAskedAndElsewhereInEachFrame) {
  const SE3d truth = SE3d::Exp({{0.3, -1, 0.2}, {1, 2, 3}});
  const auto at = [&](std::uint64_t seed, int frame) {
    return PerturbedTruth(truth, {0.02, 1}, seed, frame);
  };
  const PoseDifference difference = Difference(truth.Inverse(), at(3, 5).Inverse());
  EXPECT_NEAR(difference.distance_m, 0.02, 1e-12);
  EXPECT_NEAR(difference.angle_deg, 1, 1e-6);
  EXPECT_EQ(at(3, 5).translation.x, at(3, 5).translation.x);
  EXPECT_NE(at(3, 5).translation.x, at(3, 6).translation.x);
  EXPECT_NE(at(3, 5).translation.x, at(4, 5).translation.x);
}

// A frame half a second later: only the truth tells where it is, and how far the start is off shows
// in the cost that the alignment begins with.
TEST(TrackingRun, StartsFromTheTruthWhereAsked) {
  const World& world = StudioWorld();
  const sim::RenderOptions rendering = SmallPictures(160);
  const Frame first = RenderAt(world, rendering, 1), later = RenderAt(world, rendering, 1.5);
  const SE3d first_pose = world.path.WorldFromCamera(1), pose = world.path.WorldFromCamera(1.5);
  const auto start_cost = [&](const char* initializer) {
    TrackingRun run(rendering.camera, {"paper", "cpu", initializer, 0}, first_pose);
    run.Track(first, first_pose);
    return run.Track(later, pose).alignment.levels.front().initial_cost.mean();
  };
  const double exact = start_cost("truth"), near = start_cost("truth:0.02m,1deg");
  EXPECT_LT(exact, 0.5 * near);
  EXPECT_LT(near, start_cost("previous"));
  TrackingRun run(rendering.camera, {"paper", "cpu", "truth", 0}, first_pose);
  EXPECT_THROW(run.Track(first), Error);
}

}  // namespace
}  // namespace silt::experiments
