// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "silt/core/parallel.h"
#include "silt/experiments/tracking_run.h"
#include "silt/tracker/simd_level.h"
#include "studio_world.h"

// Whole trajectories, to the last bit, whatever computes them.
namespace silt::experiments {
namespace {

// Far enough apart for more than one keyframe.
const std::vector<Frame>& StudioFrames() {
  static const std::vector<Frame> frames = [] {
    std::vector<Frame> all;
    for (int i = 0; i < 8; ++i) {
      all.push_back(RenderAt(StudioWorld(), SmallPictures(640), 0.5 + 0.12 * i));
      all.back().time_s = 0.12 * i;
    }
    return all;
  }();
  return frames;
}

// A pose and its covariance.
using Bits = std::array<double, 7 + 36>;

struct Tracked {
  std::vector<Bits> frames;
  int keyframes = 0, lost = 0;
};

Tracked Track(const std::string& preset, const std::string& backend, int threads) {
  SetThreadCount(threads);
  TrackingRun run(SmallPictures(640).camera, {preset, backend, "auto", 0},
                  StudioWorld().path.WorldFromCamera(0.5));
  Tracked tracked;
  for (const Frame& frame : StudioFrames()) {
    const tracker::TrackedFrame at = run.Track(frame);
    const auto& [q, t] = at.world_from_camera;
    Bits& bits = tracked.frames.emplace_back(Bits{t.x, t.y, t.z, q.x, q.y, q.z, q.w});
    std::copy(at.covariance.begin(), at.covariance.end(), bits.begin() + 7);
  }
  SetThreadCount(0);
  tracked.keyframes = run.Result().keyframes();
  tracked.lost = run.Result().lost();
  return tracked;
}

class Determinism : public testing::TestWithParam<std::tuple<const char*, tracker::SimdLevel>> {};

TEST_P(Determinism, EveryLevelThreadAndRunGivesTheSameBits) {
  const auto& [preset, level] = GetParam();
  const std::vector<tracker::SimdLevel> supported = tracker::SupportedSimdLevels();
  if (std::find(supported.begin(), supported.end(), level) == supported.end()) {
    GTEST_SKIP() << "this processor has no " << tracker::Name(level);
  }
  const std::string backend = "cpu-" + tracker::Name(level);
  const Tracked expected = Track(preset, "cpu-" + tracker::Name(supported.front()), 1);
  EXPECT_EQ(expected.lost, 0);
  EXPECT_GT(expected.keyframes, 1);
  EXPECT_NE(expected.frames.front(), expected.frames.back());
  for (const int threads : {1, 2, 2}) {
    EXPECT_EQ(Track(preset, backend, threads).frames, expected.frames) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Studio, Determinism,
                         testing::Combine(testing::Values("accurate", "fast", "paper"),
                                          testing::Values(tracker::SimdLevel::kBaseline,
                                                          tracker::SimdLevel::kAvx2,
                                                          tracker::SimdLevel::kAvx512)),
                         [](const auto& p) {
                           return std::string(std::get<0>(p.param)) + "_" +
                                  tracker::Name(std::get<1>(p.param));
                         });

}  // namespace
}  // namespace silt::experiments
