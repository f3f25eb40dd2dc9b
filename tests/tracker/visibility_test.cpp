// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "analytic_room.h"
#include "silt/core/parallel.h"

namespace silt::tracker {
namespace {

// The share of the measured pixels that a motion hides.
double HiddenShare(const Image<float>& depth_m, const SE3d& current_from_reference,
                   const PinholeCamera& camera = kSmallCamera) {
  const Image<float> visible = VisibleDepth(depth_m, camera, current_from_reference);
  int measured = 0, hidden = 0;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    measured += depth_m.data()[i] > 0 ? 1 : 0;
    hidden += depth_m.data()[i] > 0 && visible.data()[i] == 0 ? 1 : 0;
  }
  return double(hidden) / measured;
}

// A wall 2 m away, and before it, 1 m away, a square whose left edge is at column 60 and right edge
// before column 100.
Image<float> SquareBeforeWall() {
  Image<float> depth_m(160, 120, 2.0f);
  for (int y = 40; y < 80; ++y) {
    for (int x = 60; x < 100; ++x) depth_m(x, y) = 1;
  }
  return depth_m;
}

TEST(VisibleDepth, AConvexRoomHidesNothing) {
  const Image<float> depth_m = RenderRoom({}).depth_m;
  EXPECT_EQ(HiddenShare(depth_m, {}), 0);
  EXPECT_EQ(HiddenShare(depth_m, SE3d::Exp({{0.1, 0.2, 0.3}, {0.2, -0.1, 0.3}})), 0);
}

// The room's floor and walls seen as flat as they get.
TEST(VisibleDepth, ASlantedSurfaceDoesNotHideItself) {
  const SE3d grazing{Quaterniond::Exp({0, 1.3, 0}), {0, 1.0, 0}};
  EXPECT_LT(HiddenShare(RenderRoom(grazing, kIclNuimCamera).depth_m, {}, kIclNuimCamera), 0.01);
}

TEST(VisibleDepth, WhatIsNearHidesWhatItMovesBefore) {
  const Image<float> depth_m = SquareBeforeWall();
  // The camera moves by 0.2 m to the left: the square moves right by 24 pixels, the wall by 12.
  const Image<float> visible = VisibleDepth(depth_m, kSmallCamera, {{}, {0.2, 0, 0}});
  const auto columns = [&](int begin, int end) {
    std::set<float> values;
    for (int x = begin; x < end; ++x) values.insert(visible(x, 60));
    return values;
  };
  EXPECT_EQ(columns(0, 60), std::set<float>{2});
  EXPECT_EQ(columns(60, 100), std::set<float>{1});
  // The square covers the wall's 12 columns to its right; a margin of up to 4 pixels is unsure.
  EXPECT_EQ(columns(100, 112), std::set<float>{0});
  EXPECT_EQ(columns(117, 160), std::set<float>{2});
  EXPECT_EQ(visible(105, 10), 2);
}

TEST(VisibleDepth, WithoutMotionOnlyTheMarginIsHidden) {
  const Image<float> visible = VisibleDepth(SquareBeforeWall(), kSmallCamera, {});
  EXPECT_EQ(visible(101, 60), 0);
  EXPECT_EQ(visible(58, 60), 0);
  EXPECT_EQ(visible(105, 60), 2);
  EXPECT_EQ(visible(54, 60), 2);
  EXPECT_EQ(visible(80, 60), 1);
}

TEST(VisibleDepth, PixelsWithoutADepthHideNothing) {
  Image<float> depth_m = SquareBeforeWall();
  const float none[] = {0, -1, std::numeric_limits<float>::quiet_NaN(),
                        std::numeric_limits<float>::infinity()};
  for (int i = 0; i < 40 * 40; ++i) depth_m(60 + i % 40, 40 + i / 40) = none[i % 4];
  const Image<float> visible = VisibleDepth(depth_m, kSmallCamera, {{}, {0.2, 0, 0}});
  EXPECT_EQ(visible(105, 60), 2);
  EXPECT_EQ(visible(60, 40), 0);
}

TEST(VisibleDepth, WildPosesAreHarmless) {
  const Image<float> depth_m = SquareBeforeWall();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(HiddenShare(depth_m, {{}, {std::nan(""), 0, 0}}), 0);
  EXPECT_EQ(HiddenShare(depth_m, {{}, {0, inf, 0}}), 0);
  EXPECT_EQ(HiddenShare(depth_m, {Quaterniond::Exp({0, 3, 0}), {0, 0, -5}}), 0);
  EXPECT_EQ(VisibleDepth({}, {1, 1, 0, 0, 0, 0}, {}).size(), 0u);
  const PinholeCamera one{1, 1, 0, 0, 1, 1};
  EXPECT_EQ(VisibleDepth(Image<float>(1, 1, 1.0f), one, {})(0, 0), 1);
}

TEST(VisibleDepth, DoesNotDependOnTheNumberOfThreads) {
  const Image<float> depth_m = RenderRoomWithBoard({}).depth_m;
  const SE3d motion = SE3d::Exp({{0, 0.02, 0}, {0.12, 0.03, 0}});
  SetThreadCount(1);
  const Image<float> expected = VisibleDepth(depth_m, kSmallCamera, motion);
  SetThreadCount(3);
  EXPECT_EQ(VisibleDepth(depth_m, kSmallCamera, motion), expected);
  SetThreadCount(0);
}

}  // namespace
}  // namespace silt::tracker
