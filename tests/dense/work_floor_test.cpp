// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/work_floor.h"

#include <gtest/gtest.h>

namespace silt::dense {
namespace {

tracker::AlignmentResult TwoLevels() {
  tracker::AlignmentResult result;
  result.levels = {{2, 10, 8, {}, {}, 3, false}, {1, 20, 16, {}, {}, 1, true}};
  return result;
}

// 4 passes over 80 pixels and 2 over 320, of 12 bytes and 122 operations each.
TEST(WorkOf, CountsPassesOverEachLevel) {
  const Work work = WorkOf(TwoLevels(), tracker::PaperPreset().alignment);
  EXPECT_EQ(work.passes, 6);
  EXPECT_EQ(work.bytes, 12 * 960);
  EXPECT_EQ(work.operations, 122 * 960);
}

TEST(WorkOf, DepthAndWeightsCostMore) {
  const Work work = WorkOf(TwoLevels(), tracker::AccuratePreset().alignment);
  EXPECT_EQ(work.bytes, 16 * 960);
  EXPECT_EQ(work.operations, (122 + 19 + 114) * 960);
}

TEST(Work, AddsAndScales) {
  Work work{1, 2, 3};
  work += Work{1, 1, 1} * 2;
  EXPECT_EQ(work.passes, 3);
  EXPECT_EQ(work.bytes, 4);
  EXPECT_EQ(work.operations, 5);
}

}  // namespace
}  // namespace silt::dense
