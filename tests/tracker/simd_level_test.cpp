// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/simd_level.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analytic_room.h"
#include "silt/core/error.h"
#include "silt/tracker/cpu_reduction.h"

namespace silt::tracker {
namespace {

TEST(SimdLevel, EveryProcessorHasTheBaseline) {
  EXPECT_EQ(SupportedSimdLevels().front(), SimdLevel::kBaseline);
  EXPECT_EQ(BestSimdLevel(), SupportedSimdLevels().back());
}

TEST(SimdLevel, NamesAreReadBack) {
  for (const SimdLevel level : SupportedSimdLevels()) {
    EXPECT_EQ(SimdLevelFromName(Name(level)), level);
  }
  EXPECT_EQ(SimdLevelFromName("auto"), BestSimdLevel());
  EXPECT_THROW(SimdLevelFromName("mmx"), Error);
}

Image<float> VisibleDepth(const CpuReduction& reduction, const LevelImages& images,
                          const SE3d& pose) {
  Image<float> visible(images.camera.width, images.camera.height, -1.0f);
  reduction.CopyVisibleDepth(images, pose, &visible);
  return visible;
}

constexpr ResidualNorm kNorm{{0.03, 0.05}, {}, false, {}};
constexpr ResidualNorm kDepthNorm{{0.03, 0.05}, {0, 0.01, 25}, true, {}};

// A width that leaves lanes of a block and of every batch empty, and one that leaves none.
TEST(SimdLevel, AllGiveTheSameBits) {
  for (const int width : {160, 171, 339}) {
    const PinholeCamera camera{120, 125, 0.5 * (width - 1), 40, width, 83};
    const SE3d motion = SE3d::Exp({{0.02, -0.03, 0.05}, {0.05, -0.02, 0.04}});
    const View reference = RenderRoomWithBoard({}, camera);
    const View current = RenderRoomWithBoard(motion.Inverse(), camera);
    Image<float> inverse_depth = current.depth_m;
    for (float& z : inverse_depth) z = 1 / z;
    const LevelImages images{
        camera,           reference.intensity, reference.depth_m, current.intensity,
        &current.depth_m, &inverse_depth};
    const CpuReduction baseline(SimdLevel::kBaseline);
    const NormalEquations expected = baseline.Equations(images, SE3d{});
    EXPECT_GT(expected.cost.pixels, width * 83 / 2);
    EXPECT_EQ(baseline.Cost(images, SE3d{}), expected.cost);
    const NormalEquations robust = baseline.Equations(images, SE3d{}, kNorm);
    EXPECT_LT(robust.cost.sum, 0.9 * expected.cost.sum);
    EXPECT_EQ(robust.cost.squares, expected.cost.squares);
    const NormalEquations with_depth = baseline.Equations(images, SE3d{}, kDepthNorm);
    EXPECT_GT(with_depth.inverse_depth.count, robust.cost.pixels / 2);
    EXPECT_EQ(with_depth.intensity, robust.intensity);
    const SE3d moved{{}, {0.3, 0, 0}};
    const Image<float> visible = VisibleDepth(baseline, images, moved);
    EXPECT_GT(std::count(visible.begin(), visible.end(), 0.0f), 0);
    for (const SimdLevel level : SupportedSimdLevels()) {
      const CpuReduction reduction(level);
      EXPECT_EQ(reduction.Equations(images, SE3d{}), expected) << Name(level) << " " << width;
      EXPECT_EQ(reduction.Cost(images, SE3d{}), expected.cost) << Name(level) << " " << width;
      EXPECT_EQ(reduction.Equations(images, SE3d{}, kNorm), robust) << Name(level) << " " << width;
      EXPECT_EQ(reduction.Equations(images, SE3d{}, kDepthNorm), with_depth) << Name(level);
      const Image<float> depth_m = VisibleDepth(reduction, images, moved);
      EXPECT_TRUE(std::equal(depth_m.begin(), depth_m.end(), visible.begin())) << Name(level);
    }
  }
}

}  // namespace
}  // namespace silt::tracker
