// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracker_options.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(TrackerOptions, APresetIsTakenAsItIs) {
  for (const std::string& preset : PresetNames()) EXPECT_NO_THROW(PresetOptions(preset)) << preset;
  EXPECT_EQ(ToJson(PresetOptions("accurate")), ToJson(tracker::AccuratePreset()));
  EXPECT_NE(ToJson(PresetOptions("fast")), ToJson(tracker::AccuratePreset()));
}

TEST(TrackerOptions, ChangesApplyToTheirOptionsAlone) {
  const auto options = PresetOptions(
      "accurate:joint=2:robust_scale=1.5:depth_residual=0:max_iterations=3-4:"
      "always_initialize=1:start=keyframe:min_keyframe_overlap=0.3:interpolant=b-spline");
  tracker::TrackerOptions expected = tracker::AccuratePreset();
  expected.keyframes.joint = 2;
  expected.alignment.robust_scale = 1.5;
  expected.alignment.depth_residual = false;
  expected.alignment.max_iterations = {3, 4};
  expected.always_initialize = true;
  expected.start = tracker::Start::kKeyframe;
  expected.keyframes.min_overlap = 0.3;
  expected.alignment.interpolant = tracker::Interpolant::kBSpline;
  EXPECT_EQ(ToJson(options), ToJson(expected));
  EXPECT_EQ(options.keyframes.joint, 2);
  EXPECT_EQ(options.alignment.interpolant, tracker::Interpolant::kBSpline);
  EXPECT_EQ(options.alignment.max_iterations, (std::vector<int>{3, 4}));
}

TEST(TrackerOptions, JsonHasGroupsAndTypes) {
  const Json json = ToJson(tracker::PaperPreset());
  EXPECT_EQ(json["alignment"]["max_iterations"], Json({2, 5, 20, 20}));
  EXPECT_EQ(json["alignment"]["exclude_hidden"], true);
  EXPECT_EQ(json["keyframes"]["max_distance_m"], 0.13);
  EXPECT_EQ(json["always_initialize"], true);
  EXPECT_EQ(json["start"], "previous");
  EXPECT_EQ(json["alignment"]["interpolant"], "bilinear");
  EXPECT_EQ(ToJson(tracker::FastPreset())["start"], "constant-velocity");
}

// The manifest tells what was in force, not what the preset would have had.
TEST(TrackerSetup, JsonHoldsWhatTheInitializerChanges) {
  const auto with = [](const char* initializer) {
    return ToJson(TrackerSetup{"fast", "cpu", initializer, 3});
  };
  EXPECT_EQ(with("auto")["always_initialize"], false);
  EXPECT_EQ(with("auto")["start"], "constant-velocity");
  EXPECT_EQ(with("identity")["always_initialize"], true);
  EXPECT_EQ(with("identity")["start"], "keyframe");
  EXPECT_EQ(with("previous")["start"], "previous");
  EXPECT_EQ(with("orb")["initializer"], "orb");
  EXPECT_EQ(with("orb")["seed"], 3);
}

TEST(TrackerOptions, WhatCannotBeIsNamed) {
  const auto parse = [](const char* preset) { return [=] { PresetOptions(preset); }; };
  EXPECT_THAT(parse("best"), ThrowsMessage<Error>(HasSubstr("'best'; there are: paper")));
  EXPECT_THAT(parse("fast:jiont=1"),
              ThrowsMessage<Error>(HasSubstr("no option is named 'jiont'; there are: max_iter")));
  EXPECT_THAT(parse("fast:joint"), ThrowsMessage<Error>(HasSubstr("'joint' gives the option no")));
  EXPECT_THAT(parse("fast:joint=two"), ThrowsMessage<Error>(HasSubstr("'joint=two' gives")));
  EXPECT_THAT(parse("fast:joint=0"), ThrowsMessage<Error>(HasSubstr("keyframes.joint is 0")));
  EXPECT_THAT(parse("fast:max_iterations=3--4"), ThrowsMessage<Error>(HasSubstr("gives the")));
  EXPECT_THAT(parse("fast:exclude_hidden=yes"), ThrowsMessage<Error>(HasSubstr("gives the")));
  EXPECT_THAT(parse("fast:start=there"), ThrowsMessage<Error>(HasSubstr("gives the")));
  EXPECT_THAT(parse("fast:interpolant=cubic"), ThrowsMessage<Error>(HasSubstr("gives the")));
  EXPECT_THAT(parse("fast:robust_scale=nan"), ThrowsMessage<Error>(HasSubstr("robust_scale")));
}

}  // namespace
}  // namespace silt::experiments
