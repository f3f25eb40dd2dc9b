// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/photo_consistency.h"

#include <algorithm>
#include <cmath>

#include "silt/experiments/spline_image.h"
#include "silt/sim/centre_rays.h"

namespace silt::experiments {
namespace {

constexpr double kSameSurface = 0.02;  // of the depth: between neighbours on one surface
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

std::uint32_t FirstTriangle(const sim::LitScene& scene, const Vec3d& origin,
                            const Vec3d& direction) {
  sim::RayPacket rays{};
  rays.Set(0, {origin.Cast<float>(), direction.Cast<float>()});
  sim::HitPacket hits;
  scene.tracer().Trace(rays, hits);
  return hits.triangle[0];
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

DepthDifferences CompareDepths(const sim::LitScene& scene, const PinholeCamera& camera,
                               const TrueView& onto, const SE3d& world_from_other) {
  DepthDifferences differences;
  const SE3d other_from_world = world_from_other.Inverse();
  const sim::CentreRays centre_rays({camera, nullptr}, onto.world_from_camera);
  const auto visit = [&](int x, int y, std::uint32_t triangle) {
    const Vec3d world = onto.world_from_camera * camera.Unproject(x, y, double(onto.depth_m(x, y)));
    const double z = (other_from_world * world).z;
    if (!(z > 0) || !std::isfinite(z)) return;
    // With a direction of z = 1 in the other camera, distances are depths.
    const Vec3d direction = (1 / z) * (world - world_from_other.translation);
    if (FirstTriangle(scene, world_from_other.translation, direction) != triangle) {
      ++differences.hidden;
      return;
    }
    const double other_z = scene.plane(triangle).Distance(world_from_other.translation, direction);
    differences.m.push_back(std::abs(other_z - z));
  };
  // The very rays that depth is rendered with, so that each pixel's triangle is the one it is of.
  constexpr int kBlock = sim::CameraRays::kBlock;
  for (int top = 0; top < camera.height; top += kBlock) {
    for (int left = 0; left < camera.width; left += kBlock) {
      sim::RayPacket rays;
      sim::HitPacket hits;
      centre_rays.Fill(left, top, rays);
      scene.tracer().TraceCoherent(rays, hits);
      for (int i = 0; i < sim::kPacketSize; ++i) {
        const int x = left + i % kBlock, y = top + i / kBlock;
        if (!onto.depth_m.Contains(x, y) || hits.triangle[i] == sim::kNoTriangle) continue;
        visit(x, y, hits.triangle[i]);
      }
    }
  }
  return differences;
}

}  // namespace silt::experiments
