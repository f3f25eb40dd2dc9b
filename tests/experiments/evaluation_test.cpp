// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

Trajectory StraightWalk(int poses, double clock_s) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    trajectory.push_back({clock_s + 0.1 * i, {{}, {0.1 * i, 0, 0}}});
  }
  return trajectory;
}

TEST(Evaluate, CountsOnlyWhatHasAPartner) {
  const Evaluation e = Evaluate(StraightWalk(40, 0), StraightWalk(21, 0));
  EXPECT_EQ(e.pairs, 21);
  EXPECT_NEAR(e.path_m, 2, 1e-12);
  EXPECT_NEAR(e.aligned_m.max, 0, 1e-12);
  ASSERT_TRUE(e.per_frames);
  EXPECT_EQ(e.per_frames->translation_m.count, 2);
}

TEST(Evaluate, TheConventionSetsTheTolerance) {
  // 15 ms late.
  EXPECT_THROW(Evaluate(StraightWalk(9, 0), StraightWalk(9, 0.015)), Error);
  EvaluationOptions tum;
  tum.convention = Convention::kTum;
  EXPECT_EQ(Evaluate(StraightWalk(9, 0), StraightWalk(9, 0.015), tum).pairs, 9);
}

TEST(Evaluate, OfOtherClocksSaysSo) {
  try {
    Evaluate(StraightWalk(9, 0), StraightWalk(9, 1e9));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("share no time"));
  }
}

TEST(Evaluate, JsonHoldsEveryFigureAndNullForAWindowThatDoesNotFit) {
  const Json json = ToJson(Evaluate(StraightWalk(12, 0), StraightWalk(12, 0)));
  EXPECT_EQ(json["pairs"], 12);
  EXPECT_EQ(json["convention"], "evo");
  for (const char* figure : {"rmse", "max", "mean", "median", "std"}) {
    EXPECT_TRUE(json["position_cm"][figure].is_number()) << figure;
    EXPECT_TRUE(json["orientation_deg"]["z"][figure].is_number()) << figure;
    EXPECT_TRUE(json["ate_aligned_m"][figure].is_number()) << figure;
  }
  EXPECT_EQ(json["rpe"]["per_frames"]["unit"], "frames");
  EXPECT_TRUE(json["rpe"]["per_metre"].is_null());
}

TEST(Evaluate, TheTableLeavesOutWhatIsNotThere) {
  const std::string table = FormatEvaluation(Evaluate(StraightWalk(5, 0), StraightWalk(5, 0)));
  EXPECT_THAT(table, testing::HasSubstr("ATE"));
  EXPECT_THAT(table, testing::Not(testing::HasSubstr("RPE")));
}

}  // namespace
}  // namespace silt::experiments
