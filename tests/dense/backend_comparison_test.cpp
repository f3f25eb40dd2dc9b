// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/backend_comparison.h"

#include <gtest/gtest.h>

#include "silt/tracker/cpu_backend.h"
#include "waves.h"

namespace silt::dense {
namespace {

TEST(TrackAll, FollowsTheCamera) {
  const std::vector<RawFrame> frames = Waves(5);
  const TrackedSequence tracked =
      TrackAll(frames, tracker::AccuratePreset(), tracker::MakeCpuBackend());
  ASSERT_EQ(tracked.poses.size(), frames.size());
  EXPECT_TRUE(tracked.new_keyframe[0]);
  EXPECT_GT(tracked.coarse_starts, 0);
  EXPECT_GT(tracked.frames_per_s, 0);
  const SequenceDifference same = Compare(tracked, tracked, frames);
  EXPECT_EQ(same.same_keyframes, 5);
  EXPECT_EQ(same.metres, 0);
  EXPECT_LT(same.rmse_a_m, 0.01);
  EXPECT_TRUE(same.Agree(5));
}

TEST(Compare, StopsWhereKeyframesDiffer) {
  const std::vector<RawFrame> frames = Waves(4);
  TrackedSequence a;
  for (const RawFrame& frame : frames) {
    a.poses.push_back(frame.world_from_camera);
    a.keyframe_ids.push_back(0);
    a.new_keyframe.push_back(false);
  }
  TrackedSequence b = a;
  b.poses[1].translation.x += 2e-6;
  b.keyframe_ids[3] = 1;
  b.poses[3].translation.y += 1;
  const SequenceDifference difference = Compare(a, b, frames);
  EXPECT_EQ(difference.same_keyframes, 3);
  EXPECT_NEAR(difference.metres, 2e-6, 1e-9);
  EXPECT_EQ(difference.rmse_a_m, 0);
  EXPECT_NEAR(difference.rmse_b_m, 0.5, 1e-6);
  EXPECT_FALSE(difference.Agree(4));
}

TEST(Agree, AsksForTenMicrometresThenTenPercent) {
  EXPECT_TRUE((SequenceDifference{9, 9e-6, 0, 1, 2}).Agree(9));
  EXPECT_FALSE((SequenceDifference{9, 1.1e-5, 0, 1, 1}).Agree(9));
  EXPECT_TRUE((SequenceDifference{5, 0, 0, 1, 1.09}).Agree(9));
  EXPECT_FALSE((SequenceDifference{5, 0, 0, 1, 1.11}).Agree(9));
}

}  // namespace
}  // namespace silt::dense
