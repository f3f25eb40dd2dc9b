// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tsdf_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::experiments {
namespace {

constexpr PinholeCamera kCamera{160, 160, 79.5, 59.5, 160, 120};
const SE3d kPose = SE3d::Exp({{0.1, 0.4, -0.2}, {0.5, -0.3, 0.2}});

// A wall at z = 1.5 m of a camera at `pose`, whose right half stands 0.5 m before the left.
tracker::Keyframe Step(const SE3d& pose, float offset_m = 0) {
  tracker::Keyframe keyframe;
  keyframe.frame.rgb = Image<Rgb8>(160, 120, {200, 100, 50});
  keyframe.frame.depth_m = Image<float>(160, 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      keyframe.frame.depth_m(x, y) = (x < 80 ? 1.5f : 1.0f) + offset_m;
    }
  }
  keyframe.frame.depth_m(40, 60) = NAN;
  keyframe.world_from_camera = pose;
  return keyframe;
}

class TsdfMeshTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!TsdfMesh({}, kCamera, 0.02)) GTEST_SKIP() << "this build has no Open3D";
  }
};

TEST_F(TsdfMeshTest, LiesOnTheSurfaceInTheWorldInItsColour) {
  const PlyModel mesh = *TsdfMesh({Step(kPose)}, kCamera, 0.02);
  EXPECT_GT(mesh.triangles.size(), 5000u);
  ASSERT_EQ(mesh.colors.size(), mesh.points.size());
  int near = 0, far = 0;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec3d p = kPose.Inverse() * mesh.points[i].Cast<double>();
    const double wall = p.x < 0 ? 1.5 : 1.0;
    EXPECT_NEAR(p.z, wall, 2e-3);
    ++(p.x < 0 ? far : near);
    EXPECT_NEAR(mesh.colors[i].r, 200, 1);
    EXPECT_NEAR(mesh.colors[i].b, 50, 1);
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(far, 1000);
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) ASSERT_LT(std::size_t(v), mesh.points.size());
  }
}

// Two measurements of the same place, 4 mm apart: their mean.
TEST_F(TsdfMeshTest, AveragesWhatKeyframesSaw) {
  const PlyModel mesh = *TsdfMesh({Step(kPose), Step(kPose, 0.004f)}, kCamera, 0.02);
  double sum = 0;
  int count = 0;
  for (const Vec3f& point : mesh.points) {
    const Vec3d p = kPose.Inverse() * point.Cast<double>();
    if (p.x > -0.2) continue;
    sum += p.z;
    ++count;
  }
  ASSERT_GT(count, 1000);
  EXPECT_NEAR(sum / count, 1.502, 5e-4);
}

TEST_F(TsdfMeshTest, IsTheSameEachTime) {
  const PlyModel a = *TsdfMesh({Step(kPose)}, kCamera, 0.04),
                 b = *TsdfMesh({Step(kPose)}, kCamera, 0.04);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    ASSERT_EQ(a.points[i].x, b.points[i].x);
    ASSERT_EQ(a.points[i].z, b.points[i].z);
  }
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace silt::experiments
