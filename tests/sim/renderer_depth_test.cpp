// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene_builder.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

// Rendered depth against geometry known by formula, in double: equal but for the rounding to float,
// which Embree's own distances miss at grazing angles.
namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{120.3, 120, 79.5, 59.5, 160, 120};
constexpr double kRelative = 2e-7;

LightingOptions NoLight() {
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 10;
  options.gather_directions = options.bounce_directions = 16;
  return options;
}

Image<float> Depth(const Scene& scene, const SE3d& world_from_camera) {
  return Renderer(scene, {.camera = kCamera}, NoLight()).RenderDepth(world_from_camera);
}

// Origin and direction of the ray through a pixel, in the world; z = 1 in the camera.
struct Ray {
  Vec3d origin, direction;
};
Ray PixelRay(const SE3d& pose, int x, int y) {
  return {pose.translation, pose.rotation * kCamera.Unproject(x, y, 1.0)};
}

TEST(RendererDepth, MatchesAPlaneUpToGrazingAngles) {
  SceneBuilder builder;
  builder.AddQuad({-200, -200, 0}, {400, 0, 0}, {0, 400, 0}, builder.AddMaterial(Vec3f{}));
  // The last looks along the floor, 89.8° off its normal half a degree below the horizon.
  for (const SE3d& pose : {LookAt({0, 0, 3}, {1, 2, 0}), LookAt({0.1, 0.2, 1.5}, {5, 1, 1.2}),
                           LookAt({0, 0, 0.5}, {100, 30, 0})}) {
    const Image<float> depth = Depth(builder.scene, pose);
    int hits = 0;
    for (int y = 0; y < kCamera.height; ++y) {
      for (int x = 0; x < kCamera.width; ++x) {
        const Ray ray = PixelRay(pose, x, y);
        const double z = -ray.origin.z / ray.direction.z;
        const Vec3d p = ray.origin + z * ray.direction;
        const bool on_floor = z > 0 && std::fmax(std::abs(p.x), std::abs(p.y)) < 199.9;
        if (!on_floor) continue;
        EXPECT_NEAR(depth(x, y) / z, 1, kRelative) << x << ", " << y << ": " << z;
        ++hits;
      }
    }
    EXPECT_GT(hits, 1000);
  }
}

TEST(RendererDepth, MissesAreZero) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{}));
  const Image<float> depth = Depth(builder.scene, LookAt({0, 0, 1}, {5, 0, 1}));
  EXPECT_EQ(depth(80, 10), 0);
  EXPECT_EQ(Depth(Scene{}, SE3d{})(0, 0), 0);
}

// Where a ray enters a box, by the slab method; infinite where it passes by.
double BoxDepth(const Ray& ray, const Vec3d& low, const Vec3d& high) {
  const double o[] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const double d[] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const double l[] = {low.x, low.y, low.z}, h[] = {high.x, high.y, high.z};
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = (l[i] - o[i]) / d[i], b = (h[i] - o[i]) / d[i];
    enter = std::fmax(enter, std::fmin(a, b));
    leave = std::fmin(leave, std::fmax(a, b));
  }
  return enter < leave ? enter : std::numeric_limits<double>::infinity();
}

TEST(RendererDepth, MatchesABox) {
  // Corners that a float holds exactly.
  const Vec3f low{-0.25f, -0.5f, 0.125f}, high{0.75f, 0.5f, 1.0f};
  SceneBuilder builder;
  builder.AddBox(low, high, builder.AddMaterial(Vec3f{}));
  const SE3d pose = LookAt({-1.5, -2, 2.2}, {0.2, 0, 0.5});
  const Image<float> depth = Depth(builder.scene, pose);
  int hits = 0, other_side_of_edge = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const double z = BoxDepth(PixelRay(pose, x, y), low.Cast<double>(), high.Cast<double>());
      if (std::isfinite(z) != (depth(x, y) > 0)) {
        ++other_side_of_edge;
      } else if (std::isfinite(z)) {
        EXPECT_NEAR(depth(x, y) / z, 1, kRelative);
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_LE(other_side_of_edge, 1);
}

// The nearest triangle that a ray meets, one after the other in double (Möller and Trumbore).
double NearestTriangle(const Mesh& mesh, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a = mesh.positions[t.vertex[0]].Cast<double>();
    const Vec3d e = mesh.positions[t.vertex[1]].Cast<double>() - a;
    const Vec3d f = mesh.positions[t.vertex[2]].Cast<double>() - a;
    const Vec3d p = Cross(ray.direction, f), s = ray.origin - a, q = Cross(s, e);
    const double determinant = Dot(e, p);
    const double u = Dot(s, p) / determinant, v = Dot(ray.direction, q) / determinant;
    const double z = Dot(f, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && z > 0) nearest = std::fmin(nearest, z);
  }
  return nearest;
}

// A ball is the polyhedron that stands for it, and the true sphere to the polyhedron's
// own error: facets of angle α lie up to r·(1 − cos²(α/2)) below the surface.
TEST(RendererDepth, MatchesASphere) {
  const double radius = 0.5;
  const int segments = 64;
  SceneBuilder builder;
  builder.AddSphere({0, 0, 0}, float(radius), segments, builder.AddMaterial(Vec3f{}));
  const SE3d pose = LookAt({0.3, -1.6, 0.4}, {0, 0, 0});
  const Image<float> depth = Depth(builder.scene, pose);
  const double half_angle = M_PI / segments;
  const double sunken = radius * (1 - std::cos(half_angle) * std::cos(half_angle));
  int hits = 0;
  for (int y = 1; y < kCamera.height; y += 4) {
    for (int x = 1; x < kCamera.width; x += 4) {
      const Ray ray = PixelRay(pose, x, y);
      const double z = NearestTriangle(builder.scene.mesh, ray);
      EXPECT_EQ(std::isfinite(z), depth(x, y) > 0) << x << ", " << y;
      if (!(depth(x, y) > 0)) continue;
      EXPECT_NEAR(depth(x, y) / z, 1, kRelative);
      const double from_center = Norm(ray.origin + double(depth(x, y)) * ray.direction);
      EXPECT_LE(from_center, radius * (1 + kRelative));
      EXPECT_GE(from_center, radius - sunken);
      ++hits;
    }
  }
  EXPECT_GT(hits, 150);
}

}  // namespace
}  // namespace silt::sim
