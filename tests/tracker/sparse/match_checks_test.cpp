// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/match_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "silt/core/camera.h"
#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/core/se3.h"
#include "textured_planes.h"

namespace silt::tracker {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Feature At(double x, double y) {
  Feature feature;
  feature.pixel = {x, y};
  feature.scale = 2;
  return feature;
}

TEST(NearMatches, AreWithinFiveTimesTheSmallestDistance) {
  const std::vector<FeatureMatch> matches = {
      {0, 0, 0.3f}, {1, 1, 0.1f}, {2, 2, 0.499f}, {3, 3, 0.501f}, {4, 4, 1.2f}};
  EXPECT_THAT(KeepNearMatches(matches), ElementsAre(matches[0], matches[1], matches[2]));
}

// One chance agreement must not throw all others out.
TEST(NearMatches, HaveAFloorUnderTheThreshold) {
  const std::vector<FeatureMatch> matches = {{0, 0, 0}, {1, 1, 0.2f}, {2, 2, 0.3f}};
  EXPECT_THAT(KeepNearMatches(matches), ElementsAre(matches[0], matches[1]));
  MatchCheckOptions letter;
  letter.distance_floor = 0;
  EXPECT_THAT(KeepNearMatches(matches, letter), ElementsAre(matches[0]));
  EXPECT_THAT(KeepNearMatches({}), IsEmpty());
}

TEST(CorrelatedMatches, LookAlikeAroundTheFeatures) {
  const View view = ViewOfPlanes(kIclNuimCamera, {});
  const std::vector<Feature> keyframe = {At(400, 200), At(450.5, 300.25), At(500, 100)};
  const std::vector<Feature> current = {At(400, 200), At(450.5, 300.25), At(420, 330)};
  const std::vector<FeatureMatch> matches = {{0, 0, 0.1f}, {2, 2, 0.1f}, {1, 1, 0.1f}};
  const auto kept =
      KeepCorrelatedMatches(matches, {view.intensity, keyframe}, {view.intensity, current});
  EXPECT_THAT(kept, ElementsAre(matches[0], matches[2]));
  const Image<float> blank(640, 480, 0.5f);
  EXPECT_THAT(KeepCorrelatedMatches(matches, {view.intensity, keyframe}, {blank, current}),
              IsEmpty());
}

// Points in front of two cameras, their images, and three matches moved off their epipolar lines.
struct TwoViews {
  std::vector<Feature> keyframe, current;
  std::vector<FeatureMatch> matches;
};

TwoViews RandomPoints(int count) {
  const CounterRandom random(11);
  const SE3d current_from_keyframe = SE3d::Exp({{0.02, -0.05, 0.03}, {0.1, 0.02, -0.03}});
  TwoViews views;
  for (int i = 0; i < count; ++i) {
    const auto draw = std::uint64_t(3 * i);
    const Vec3d point = kIclNuimCamera.Unproject(40 + 560 * random.Uniform(draw),
                                                 40 + 400 * random.Uniform(draw + 1),
                                                 1 + 2 * random.Uniform(draw + 2));
    const Vec2d a = kIclNuimCamera.Project(point);
    const Vec2d b = kIclNuimCamera.Project(current_from_keyframe * point);
    views.keyframe.push_back(At(a.x, a.y));
    views.current.push_back(At(b.x, b.y));
    views.matches.push_back({i, i, 0.1f});
  }
  return views;
}

TEST(EpipolarMatches, LieOnTheirEpipolarLines) {
  TwoViews views = RandomPoints(60);
  // The motion is mostly sideways and epipolar lines are near horizontal: moved up, these leave.
  for (std::size_t outlier : {3u, 20u, 41u}) views.current[outlier].pixel.y -= 25;
  const auto kept = KeepEpipolarMatches(views.matches, views.keyframe, views.current);
  EXPECT_EQ(kept.size(), 57u);
  for (const FeatureMatch& match : kept) {
    EXPECT_TRUE(match.keyframe != 3 && match.keyframe != 20 && match.keyframe != 41);
  }
  EXPECT_EQ(KeepEpipolarMatches(views.matches, views.keyframe, views.current), kept);
}

TEST(EpipolarMatches, NeedEightAndSurviveDegenerateOnes) {
  const TwoViews views = RandomPoints(8);
  EXPECT_EQ(KeepEpipolarMatches(views.matches, views.keyframe, views.current).size(), 8u);
  const std::vector<FeatureMatch> seven(views.matches.begin(), views.matches.end() - 1);
  EXPECT_THAT(KeepEpipolarMatches(seven, views.keyframe, views.current), IsEmpty());
  const std::vector<Feature> one_place(8, At(100, 100));
  EXPECT_NO_THROW(KeepEpipolarMatches(views.matches, one_place, one_place));
}

TEST(MatchChecks, RejectOptionsOutOfRange) {
  const auto invalid = [](auto change) {
    MatchCheckOptions options;
    change(options);
    EXPECT_THROW(options.Validate(), Error);
  };
  invalid([](auto& options) { options.distance_factor = 0.5; });
  invalid([](auto& options) { options.distance_floor = -1; });
  invalid([](auto& options) { options.min_correlation = 1; });
  invalid([](auto& options) { options.patch_radius = 0; });
  invalid([](auto& options) { options.epipolar_px = 0; });
  invalid([](auto& options) { options.epipolar_confidence = 1; });
  EXPECT_NO_THROW(MatchCheckOptions().Validate());
}

}  // namespace
}  // namespace silt::tracker
