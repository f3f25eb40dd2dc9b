// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/depth_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analytic_room.h"

namespace silt::tracker {
namespace {

int Dropped(const Image<float>& depth_m) {
  return int(std::count(depth_m.begin(), depth_m.end(), 0.0f));
}

// A step between columns 9 and 10.
Image<float> Step() {
  Image<float> depth_m(20, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 20; ++x) depth_m(x, y) = x < 10 ? 1.0f : 1.1f;
  }
  return depth_m;
}

TEST(DepthEdges, TheMarginLiesOnBothSidesOfAStep) {
  for (const int margin : {1, 2, 3}) {
    const Image<float> kept = WithoutDepthEdges(Step(), margin);
    for (int x = 0; x < 20; ++x) {
      const bool near_step = x >= 10 - margin && x < 10 + margin;
      EXPECT_EQ(kept(x, 2) == 0, near_step) << margin << " " << x;
    }
  }
}

TEST(DepthEdges, HoldForColumnsAsForRows) {
  Image<float> upright(5, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 5; ++x) upright(x, y) = Step()(y, x);
  }
  const Image<float> kept = WithoutDepthEdges(upright, 2), expected = WithoutDepthEdges(Step(), 2);
  for (int y = 0; y < 20; ++y) EXPECT_EQ(kept(3, y), expected(y, 3)) << y;
}

TEST(DepthEdges, HolesHaveEdges) {
  Image<float> depth_m(9, 9);
  std::fill(depth_m.begin(), depth_m.end(), 2.0f);
  depth_m(4, 4) = 0;
  EXPECT_EQ(Dropped(WithoutDepthEdges(depth_m, 1)), 5);
  EXPECT_EQ(Dropped(WithoutDepthEdges(depth_m, 2)), 21);  // that cross, a pixel wider all round
}

TEST(DepthEdges, AWalkedRoomHasOnlyItsBoards) {
  const View room = RenderRoom({});
  EXPECT_EQ(Dropped(WithoutDepthEdges(room.depth_m, 2)), 0);
  EXPECT_GT(Dropped(WithoutDepthEdges(RenderRoomWithBoard({}).depth_m, 2)), 500);
}

TEST(DepthEdges, NoMarginKeepsAll) {
  const Image<float> step = Step();
  const Image<float> kept = WithoutDepthEdges(step, 0);
  EXPECT_TRUE(std::equal(kept.begin(), kept.end(), step.begin()));
  EXPECT_TRUE(WithoutDepthEdges({}, 2).empty());
  EXPECT_EQ(WithoutDepthEdges(Image<float>(1, 1), 3).width(), 1);
}

}  // namespace
}  // namespace silt::tracker
