// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_planes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene_builder.h"

namespace silt::sim {
namespace {

TEST(SurfacePlanes, HoldTheCornersOfTheirTriangles) {
  const Scene scene = RoomWithBoxAndBall();
  const std::vector<SurfacePlane> planes = SurfacePlanes(scene);
  ASSERT_EQ(planes.size(), scene.mesh.triangles.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_NEAR(Norm(planes[i].normal), 1, 1e-12);
    for (const std::uint32_t v : scene.mesh.triangles[i].vertex) {
      const Vec3d corner = scene.mesh.positions[v].Cast<double>();
      EXPECT_NEAR(Dot(planes[i].normal, corner), planes[i].offset_m, 1e-12);
    }
  }
}

TEST(SurfacePlanes, FaceTheFrontAndMeetRaysThere) {
  SceneBuilder builder;
  builder.AddQuad({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(Vec3f{}));
  const SurfacePlane plane = SurfacePlanes(builder.scene)[0];
  EXPECT_EQ(plane.normal.z, 1);
  EXPECT_NEAR(plane.Distance({5, 6, 8}, {1, 1, -2}), 3, 1e-15);
  EXPECT_FALSE(std::isfinite(plane.Distance({5, 6, 8}, {1, 1, 0})));
}

TEST(SurfacePlanes, KnowTheirInstanceAndMaterialFromOneOn) {
  SceneBuilder builder;
  const int first = builder.AddMaterial(Vec3f{}), second = builder.AddMaterial(Vec3f{});
  for (const int material : {first, second, second}) {
    builder.AddQuad({}, {1, 0, 0}, {0, 1, 0}, material);
  }
  builder.scene.instances = {{"a", 0, 2}, {"b", 2, 2}};
  const std::vector<SurfacePlane> planes = SurfacePlanes(builder.scene);
  EXPECT_EQ(planes[1].instance, 1u);
  EXPECT_EQ(planes[2].instance, 2u);
  EXPECT_EQ(planes[4].instance, 0u);  // of none
  EXPECT_EQ(planes[0].material, 1u);
  EXPECT_EQ(planes[5].material, 2u);
}

TEST(SurfacePlanes, OfATriangleWithoutAreaAreMetNowhere) {
  SceneBuilder builder;
  builder.AddQuad({1, 2, 3}, {1, 0, 0}, {2, 0, 0}, builder.AddMaterial(Vec3f{}));
  const SurfacePlane plane = SurfacePlanes(builder.scene)[0];
  EXPECT_EQ(Norm(plane.normal), 0);
  EXPECT_FALSE(std::isfinite(plane.Distance({}, {1, 2, 3})));
}

}  // namespace
}  // namespace silt::sim
