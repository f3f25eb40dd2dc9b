// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/tracker/cpu_backend.h"
#include "studio_world.h"

namespace silt::experiments {
namespace {

FrameTiming Timing(double load_ms, double total_ms) {
  FrameTiming timing;
  timing.load_ms = load_ms;
  timing.stages.total_ms = total_ms;
  timing.stages.pyramid_ms = 2;
  return timing;
}

TEST(Timing, TakesMediansOfAllButTheFirstFrame) {
  const std::vector<FrameTiming> frames = {Timing(1000, 5000), Timing(1, 40), Timing(3, 10),
                                           Timing(2, 20)};
  const auto stages = SummarizeTiming(frames, {4.5, 12});
  EXPECT_EQ(stages.front().stage, "load");
  EXPECT_EQ(stages.front().median_ms, 2);
  EXPECT_EQ(stages.front().percentile_90_ms, 3);
  EXPECT_EQ(stages.front().paper_ms, 3.5);
  EXPECT_EQ(stages[1].median_ms, 2);
  EXPECT_EQ(stages[4].median_ms, 12);
  EXPECT_EQ(stages.back().stage, "frame");
  EXPECT_EQ(stages.back().median_ms, 22);
  EXPECT_EQ(stages.back().percentile_90_ms, 41);
}

TEST(Timing, NeedsTwoFrames) {
  EXPECT_THROW(SummarizeTiming({Timing(1, 1)}, {}), Error);
  EXPECT_THROW(SummarizeTiming({}, {}), Error);
}

TEST(Timing, IsNullWhereThePaperIsSilent) {
  const Json rows = StageRows(SummarizeTiming({Timing(1, 1), Timing(1, 1)}, {1, 1}));
  EXPECT_EQ(rows[2].at("paper_ms"), 31.3);
  EXPECT_TRUE(rows[5].at("paper_ms").is_null());
  EXPECT_THAT(FormatTiming(SummarizeTiming({Timing(1, 1), Timing(1, 1)}, {1, 1})),
              testing::HasSubstr("initial estimate"));
}

// Three times the same frame.
class ThreeFrames : public FrameSource {
 public:
  explicit ThreeFrames(const FramePair& pair) : pair_(pair) {}
  const PinholeCamera& camera() const override { return pair_.camera; }
  int size() const override { return 3; }
  std::optional<Frame> Next() override {
    if (given_ == 3) return {};
    Frame frame = pair_.reference;
    frame.time_s = given_++;
    return frame;
  }

 private:
  const FramePair& pair_;
  int given_ = 0;
};

TEST(Timing, TimesATrackerAndItsSource) {
  const FramePair pair = RenderPair(StudioWorld(), SmallPictures(160), 1, 1.1);
  ThreeFrames source(pair);
  tracker::KeyframeTracker tracker(pair.camera, tracker::PaperPreset(), tracker::MakeCpuBackend(),
                                   nullptr);
  const std::vector<FrameTiming> timings = TimeFrames(source, tracker);
  ASSERT_EQ(timings.size(), 3u);
  EXPECT_TRUE(timings[0].new_keyframe);
  EXPECT_EQ(timings[2].time_s, 2);
  EXPECT_GT(timings[1].stages.total_ms, 0);
  EXPECT_EQ(FrameRows(timings).size(), 3u);
  const auto backend = tracker::MakeCpuBackend();
  const CallTimes calls = TimeFullSizeCalls(*backend, pair, 3);
  EXPECT_GT(calls.residual_ms, 0);
  EXPECT_GT(calls.jacobian_ms, 0);
}

}  // namespace
}  // namespace silt::experiments
