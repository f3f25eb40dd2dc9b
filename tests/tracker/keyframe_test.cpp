// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe.h"

#include <gtest/gtest.h>

#include <string>

namespace silt::tracker {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

SE3d Pose(const Vec3d& position_m, const Vec3d& rotation_deg = {}) {
  return {Quaterniond::Exp(kDegree * rotation_deg), position_m};
}

std::vector<Keyframe> KeyframesAt(const std::vector<SE3d>& poses) {
  std::vector<Keyframe> keyframes;
  for (const SE3d& pose : poses) {
    keyframes.push_back({int(keyframes.size()), {}, {}, pose});
  }
  return keyframes;
}

struct RuleCase {
  const char* name;
  std::vector<SE3d> keyframes;
  SE3d camera;
  bool needs_keyframe;
};

void PrintTo(const RuleCase& rule, std::ostream* out) { *out << rule.name; }

class KeyframeRule : public testing::TestWithParam<RuleCase> {};

TEST_P(KeyframeRule, Holds) {
  const RuleCase& rule = GetParam();
  EXPECT_EQ(NeedsKeyframe(KeyframesAt(rule.keyframes), rule.camera, {}), rule.needs_keyframe);
}

const SE3d kOrigin = Pose({0, 0, 0});

INSTANTIATE_TEST_SUITE_P(
    Paper, KeyframeRule,
    testing::Values(
        RuleCase{"the_first_frame", {}, kOrigin, true},
        RuleCase{"no_motion", {kOrigin}, kOrigin, false},
        RuleCase{"just_within_the_distance", {kOrigin}, Pose({0.0, 0.0, 0.1299}), false},
        RuleCase{"just_beyond_the_distance", {kOrigin}, Pose({0.0, 0.0, 0.1301}), true},
        // Each component is below 0.13 m; the distance is not.
        RuleCase{"the_distance_is_euclidean", {kOrigin}, Pose({0.08, 0.08, 0.08}), true},
        RuleCase{"far_from_the_last_but_near_an_older_one",
                 {kOrigin, Pose({0.2, 0, 0}), Pose({0.4, 0, 0})},
                 Pose({0.1, 0, 0}),
                 false},
        RuleCase{"far_from_every_one",
                 {kOrigin, Pose({0.2, 0, 0}), Pose({0.4, 0, 0})},
                 Pose({0.2, 0.14, 0}),
                 true},
        RuleCase{"just_within_the_rotation", {kOrigin}, Pose({}, {0, 29.9, 0}), false},
        RuleCase{"just_beyond_the_rotation", {kOrigin}, Pose({}, {0, -30.1, 0}), true},
        // The angle about the one axis is 17.9 degrees, the sum over x, y and z is 31.
        RuleCase{
            "the_rotation_is_summed_over_axes", {kOrigin}, Pose({}, {10.4, -10.3, 10.3}), true},
        RuleCase{"the_sum_may_stay_below", {kOrigin}, Pose({}, {9, -9, 9}), false},
        RuleCase{"rotation_counts_from_the_last_created",
                 {kOrigin, Pose({0.2, 0, 0}, {0, 40, 0})},
                 Pose({0, 0, 0}, {0, 5, 0}),
                 true},
        RuleCase{"rotation_from_older_ones_does_not_count",
                 {kOrigin, Pose({0.2, 0, 0}, {0, 40, 0})},
                 Pose({0, 0, 0}, {0, 35, 0}),
                 false}),
    [](const auto& p) { return std::string(p.param.name); });

TEST(NearestKeyframe, GoesByPositionAlone) {
  const std::vector<Keyframe> keyframes =
      KeyframesAt({Pose({0, 0, 0}, {0, 90, 0}), Pose({0.1, 0, 0}), Pose({0.3, 0, 0})});
  EXPECT_EQ(NearestKeyframe(keyframes, Pose({0.04, 0, 0})), 0);
  EXPECT_EQ(NearestKeyframe(keyframes, Pose({0.06, 0, 0})), 1);
  EXPECT_EQ(NearestKeyframe(keyframes, Pose({9, 0, 0})), 2);
}

TEST(NearestKeyframes, ATurnMayCountAsADisplacement) {
  std::vector<Keyframe> keyframes(3);
  keyframes[0].world_from_camera = SE3d{Quaterniond::Exp({0, 0.5, 0}), {0, 0, 0}};
  keyframes[1].world_from_camera = SE3d{{}, {0.1, 0, 0}};
  keyframes[2].world_from_camera = SE3d{{}, {5, 0, 0}};
  KeyframeOptions options;
  EXPECT_EQ(NearestKeyframes(keyframes, SE3d{}, options, 2), (KeyframeIds{0, 1}));
  options.metres_per_radian = 0.3;
  EXPECT_EQ(NearestKeyframes(keyframes, SE3d{}, options, 1), KeyframeIds{1});
  // The third is too far away to help.
  EXPECT_EQ(NearestKeyframes(keyframes, SE3d{}, options, 3), (KeyframeIds{1, 0}));
}

TEST(NearestKeyframe, TheEarlierOfTwoAtTheSameDistance) {
  EXPECT_EQ(NearestKeyframe(KeyframesAt({Pose({0.5, 0, 0}), Pose({-0.5, 0, 0})}), kOrigin), 0);
}

}  // namespace
}  // namespace silt::tracker
