// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_builder.h"
#include "silt/core/parallel.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{120.3, 120, 74.5, 54.5, 150, 110};

LightingOptions NoLight() {
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 10;
  options.gather_directions = options.bounce_directions = 16;
  return options;
}

TEST(RendererGeometry, DepthIsThatOfRenderDepth) {
  const Renderer renderer(RoomWithBoxAndBall(), {.camera = kCamera}, NoLight());
  const SE3d pose = LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7});
  EXPECT_EQ(renderer.RenderGeometry(pose).depth_m, renderer.RenderDepth(pose));
}

// Each normal is that of the surface through the neighbours' points, and looks at the camera.
TEST(RendererGeometry, NormalsArePerpendicularToTheSurfaceInCameraCoordinates) {
  const Renderer renderer(RoomWithBoxAndBall(), {.camera = kCamera}, NoLight());
  const GeometryBuffers g = renderer.RenderGeometry(LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7}));
  const auto point = [&](int x, int y) { return kCamera.Unproject(x, y, double(g.depth_m(x, y))); };
  int flat = 0;
  for (int y = 1; y < kCamera.height; ++y) {
    for (int x = 1; x < kCamera.width; ++x) {
      const Vec3f& n = g.normal_camera(x, y);
      EXPECT_NEAR(Norm(n), 1, 1e-6);
      EXPECT_LT(Dot(n.Cast<double>(), point(x, y)), 0);
      if (Norm(n - g.normal_camera(x - 1, y)) > 0 || Norm(n - g.normal_camera(x, y - 1)) > 0 ||
          g.instance(x, y) != g.instance(x - 1, y) || g.instance(x, y) != g.instance(x, y - 1)) {
        continue;
      }
      // Coplanar, unless the same direction belongs to another plane.
      const Vec3d right = point(x, y) - point(x - 1, y), down = point(x, y) - point(x, y - 1);
      if (std::max(Norm(right), Norm(down)) > 0.1) continue;
      EXPECT_NEAR(Dot(n.Cast<double>(), right), 0, 1e-5);
      EXPECT_NEAR(Dot(n.Cast<double>(), down), 0, 1e-5);
      ++flat;
    }
  }
  EXPECT_GT(flat, 5000);
}

TEST(RendererGeometry, TheBackOfASurfaceLooksAtTheCameraToo) {
  SceneBuilder builder;
  builder.AddQuad({-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, builder.AddMaterial(Vec3f{}));
  const Renderer renderer(builder.scene, {.camera = kCamera}, NoLight());
  for (const double height : {1.0, -1.0}) {
    const SE3d pose = LookAt({0, 0.1, height}, {0, 0, 0});
    const GeometryBuffers g = renderer.RenderGeometry(pose);
    const Vec3d world = pose.rotation * g.normal_camera(75, 55).Cast<double>();
    EXPECT_NEAR(world.z, height, 1e-6);
  }
}

TEST(RendererGeometry, IdsNameInstancesAndMaterials) {
  SceneBuilder builder;
  const int left = builder.AddMaterial(Vec3f{}), right = builder.AddMaterial(Vec3f{});
  builder.AddQuad({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, left);
  builder.AddQuad({0, -1, 0}, {1, 0, 0}, {0, 2, 0}, right);
  builder.scene.instances = {{"whole", 0, 4}};
  const Renderer renderer(builder.scene, {.camera = kCamera}, NoLight());
  const GeometryBuffers g = renderer.RenderGeometry(LookAt({0, -0.1, 3}, {0, 0, 0}));
  EXPECT_EQ(g.material(65, 55), 1u);
  EXPECT_EQ(g.material(85, 55), 2u);
  EXPECT_EQ(g.instance(65, 55), 1u);
  EXPECT_EQ(g.instance(85, 55), 1u);
  EXPECT_EQ(g.material(0, 55) + g.instance(0, 55), 0u);  // beside the surface
  EXPECT_EQ(Norm(g.normal_camera(0, 55)), 0);
  EXPECT_EQ(g.depth_m(0, 55), 0);
}

TEST(RendererGeometry, DoesNotDependOnTheNumberOfThreads) {
  GeometryBuffers buffers[3];
  for (const int threads : {1, 2}) {
    SetThreadCount(threads);
    const Renderer renderer(RoomWithBoxAndBall(), {.camera = kCamera}, NoLight());
    buffers[threads] = renderer.RenderGeometry(LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7}));
  }
  SetThreadCount(0);
  EXPECT_EQ(buffers[1].depth_m, buffers[2].depth_m);
  EXPECT_EQ(buffers[1].instance, buffers[2].instance);
  EXPECT_EQ(buffers[1].material, buffers[2].material);
}

}  // namespace
}  // namespace silt::sim
