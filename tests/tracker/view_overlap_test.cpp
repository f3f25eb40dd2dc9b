// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/view_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic_room.h"

namespace silt::tracker {
namespace {

const Image<float> kWall(160, 120, 2.0f);

SE3d Moved(double x_m) { return {{}, {x_m, 0, 0}}; }

TEST(ViewOverlap, IsWholeFromTheSamePlace) { EXPECT_EQ(ViewOverlap(kWall, kSmallCamera, {}), 1); }

// A wall 2 m away is 160·2/fx = 2.66 m wide in the picture.
TEST(ViewOverlap, IsTheShareOfTheWallThatIsStillSeen) {
  EXPECT_NEAR(ViewOverlap(kWall, kSmallCamera, Moved(0.665)), 0.75, 0.06);
  EXPECT_NEAR(ViewOverlap(kWall, kSmallCamera, Moved(-1.33)), 0.5, 0.06);
  EXPECT_EQ(ViewOverlap(kWall, kSmallCamera, Moved(2.7)), 0);
  EXPECT_NEAR(ViewOverlap(kWall, kSmallCamera, {{}, {0, 1, 0}}), 0.5, 0.1);
}

TEST(ViewOverlap, WhatLiesBehindTheCameraIsNotSeen) {
  EXPECT_EQ(ViewOverlap(kWall, kSmallCamera, {{}, {0, 0, -4}}), 0);
  EXPECT_EQ(ViewOverlap(kWall, kSmallCamera, {Quaterniond::Exp({0, 3.1, 0}), {}}), 0);
}

TEST(ViewOverlap, CountsMeasuredPixelsAlone) {
  Image<float> half = kWall;
  for (int y = 0; y < 120; ++y) {
    for (int x = 80; x < 160; ++x) half(x, y) = x % 2 == 0 ? 0 : NAN;
  }
  EXPECT_EQ(ViewOverlap(half, kSmallCamera, {}), 1);
  // What goes out of the picture on the left is half of what is left.
  EXPECT_NEAR(ViewOverlap(half, kSmallCamera, Moved(-0.665)), 0.5, 0.11);
  EXPECT_EQ(ViewOverlap(Image<float>(160, 120), kSmallCamera, {}), 0);
}

}  // namespace
}  // namespace silt::tracker
