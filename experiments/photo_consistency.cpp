// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/photo_consistency.h"

#include <algorithm>
#include <cmath>

#include "silt/experiments/spline_image.h"

namespace silt::experiments {
namespace {

constexpr double kSameSurface = 0.02;  // of the depth: between neighbours on one surface
constexpr double kInBetween_m = 1e-3;  // nearer things hide the point
constexpr int kMargin = 5;             // of pixels, in which a spline feels the picture's end

// Whether the sixteen pixels next to (u, v) lie on the surface at depth z.
bool OnOneSurface(const Image<float>& depth_m, double u, double v, double z) {
  for (int j = -1; j <= 2; ++j) {
    for (int i = -1; i <= 2; ++i) {
      const double there = depth_m(int(u) + i, int(v) + j);
      if (!(std::abs(there - z) < kSameSurface * z)) return false;
    }
  }
  return true;
}

}  // namespace

PhotoDifferences ComparePictures(const PinholeCamera& camera, const TrueView& onto,
                                 const TrueView& from) {
  PhotoDifferences differences;
  const SplineImage from_luma(from.luma);
  const SE3d from_onto = from.world_from_camera.Inverse() * onto.world_from_camera;
  for (int y = 1; y + 1 < camera.height; ++y) {
    for (int x = 1; x + 1 < camera.width; ++x) {
      const double z = onto.depth_m(x, y);
      if (!(z > 0)) continue;
      const Vec3d point = from_onto * camera.Unproject(x, y, z);
      const Vec2d there = camera.Project(point);
      const bool inside = point.z > 0 && there.x >= kMargin && there.y >= kMargin &&
                          there.x < camera.width - 1 - kMargin &&
                          there.y < camera.height - 1 - kMargin;
      if (!inside || !OnOneSurface(from.depth_m, there.x, there.y, point.z) ||
          !OnOneSurface(onto.depth_m, std::min(x, camera.width - 3), std::min(y, camera.height - 3),
                        z)) {
        ++differences.hidden;
        continue;
      }
      const auto difference =
          float(std::abs(from_luma.At(there.x, there.y) - double(onto.luma(x, y))));
      differences.all.push_back(difference);
      const double gradient = 0.5 * std::hypot(onto.luma(x + 1, y) - onto.luma(x - 1, y),
                                               onto.luma(x, y + 1) - onto.luma(x, y - 1));
      if (gradient >= 0.5 && gradient <= 2) differences.at_gradients.push_back(difference);
    }
  }
  return differences;
}

std::vector<double> CompareDepths(const sim::LitScene& scene, const PinholeCamera& camera,
                                  const TrueView& onto, const SE3d& world_from_other) {
  std::vector<double> differences;
  const SE3d other_from_world = world_from_other.Inverse();
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double z = onto.depth_m(x, y);
      if (!(z > 0)) continue;
      const Vec3d world = onto.world_from_camera * camera.Unproject(x, y, z);
      const Vec3d point = other_from_world * world;
      if (!(point.z > 0) || !std::isfinite(point.z)) continue;
      // With a direction of z = 1 in the other camera, distances are depths.
      const Vec3d direction = (1 / point.z) * (world - world_from_other.translation);
      sim::RayPacket rays{};
      rays.Set(0, {world_from_other.translation.Cast<float>(), direction.Cast<float>()});
      sim::HitPacket hits;
      scene.tracer().Trace(rays, hits);
      if (hits.triangle[0] == sim::kNoTriangle) continue;
      const double other_z =
          scene.plane(hits.triangle[0]).Distance(world_from_other.translation, direction);
      const double difference = std::abs(other_z - point.z);
      if (difference < kInBetween_m) differences.push_back(difference);
    }
  }
  return differences;
}

}  // namespace silt::experiments
