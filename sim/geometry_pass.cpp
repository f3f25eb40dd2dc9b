// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/geometry_pass.h"

#include <algorithm>
#include <type_traits>

#include "silt/sim/image_tiles.h"

namespace silt::sim {

namespace {

// A triangle's plane n·x = d before a row of pixels, whose rays o + z·(c + u·a + v·b) meet it at
// z = (d − n·o) / (n·c + u·n·a + v·n·b).
class PlaneInView {
 public:
  void Set(const SurfacePlane& plane, const CameraRays& rays, const Mat3d& camera_from_world) {
    numerator_ = plane.offset_m - Dot(plane.normal, rays.origin());
    at_corner_ = Dot(plane.normal, rays.corner());
    along_u_ = Dot(plane.normal, rays.along_u());
    along_v_ = Dot(plane.normal, rays.along_v());
    normal_ = (camera_from_world * plane.normal).Cast<float>();
  }
  // n·direction: below 0 the front is seen.
  double Slope(const Vec2d& pixel) const {
    return at_corner_ + pixel.x * along_u_ + pixel.y * along_v_;
  }
  double Depth(double slope) const { return numerator_ / slope; }
  const Vec3f& normal() const { return normal_; }

 private:
  double numerator_ = 0, at_corner_ = 0, along_u_ = 0, along_v_ = 0;
  Vec3f normal_;
};

// Neighbours in a row that see one surface.
struct HitRun {
  int x, y;
  const SurfacePlane& plane;
  const float* depth_m;
  Vec3f normal_camera;
};

bool AllMeetOneTriangle(const HitPacket& hits) {
  std::uint32_t differences = 0;
  for (int i = 0; i < kPacketSize; ++i) differences |= hits.triangle[i] ^ hits.triangle[0];
  return differences == 0 && hits.triangle[0] != kNoTriangle;
}

// A block of pixels of which each sees something of its own.
template <typename Visit>
void VisitPixels(const LitScene& lit, const CentreRays& centre_rays, const Vec2<int>& corner,
                 const HitPacket& hits, const Visit& visit) {
  for (const std::uint32_t triangle : hits.triangle) {
    if (triangle != kNoTriangle) __builtin_prefetch(&lit.plane(triangle));
  }
  // Most pixels see the plane that their neighbour sees.
  PlaneInView in_view;
  std::uint32_t known = kNoTriangle;
  int known_row = -1;
  for (int i = 0; i < kPacketSize; ++i) {
    const std::uint32_t triangle = hits.triangle[i];
    if (triangle == kNoTriangle) continue;
    const int x = corner.x + i % CameraRays::kBlock, y = corner.y + i / CameraRays::kBlock;
    const CameraRays& row = centre_rays.OfRow(y);
    const SurfacePlane& plane = lit.plane(triangle);
    if (triangle != known || (centre_rays.rolling() && y != known_row)) {
      in_view.Set(plane, row, centre_rays.RotationOfRow(y));
      known = triangle;
      known_row = y;
    }
    const double slope = in_view.Slope(row.PinholePixel(x, y)), z = in_view.Depth(slope);
    const float depth_m = z > 0 && z < double(RayPacket::kFar) ? float(z) : hits.distance[i];
    visit(HitRun{x, y, plane, &depth_m, slope < 0 ? in_view.normal() : -in_view.normal()},
          std::integral_constant<int, 1>());
  }
}

// A block of pixels that all see one triangle: the same, in rows.
template <typename Visit>
void VisitPlane(const LitScene& lit, const CentreRays& centre_rays, const Vec2<int>& corner,
                const HitPacket& hits, const Visit& visit) {
  constexpr int kBlock = CameraRays::kBlock;
  const SurfacePlane& plane = lit.plane(hits.triangle[0]);
  PlaneInView in_view;
  for (int j = 0; j < kBlock; ++j) {
    const int y = corner.y + j;
    const CameraRays& row = centre_rays.OfRow(y);
    if (j == 0 || centre_rays.rolling()) in_view.Set(plane, row, centre_rays.RotationOfRow(y));
    double slope[kBlock];
    for (int i = 0; i < kBlock; ++i) slope[i] = in_view.Slope(row.PinholePixel(corner.x + i, y));
    float depth_m[kBlock];
    for (int i = 0; i < kBlock; ++i) {
      const double z = in_view.Depth(slope[i]);
      depth_m[i] = z > 0 && z < double(RayPacket::kFar) ? float(z) : hits.distance[kBlock * j + i];
    }
    visit(HitRun{corner.x, y, plane, depth_m, slope[0] < 0 ? in_view.normal() : -in_view.normal()},
          std::integral_constant<int, kBlock>());
  }
}

// Calls visit(run, its length) for all pixels that see something, in parallel.
template <typename Visit>
void ForEachHit(const LitScene& lit, const CentreRays& centre_rays, const Visit& visit) {
  const PinholeCamera& camera = centre_rays.camera();
  ForEachTile(camera.width, camera.height, [&](const ImageTile& tile) {
    RayPacket rays;
    HitPacket hits;
    ForEachBlock(tile, [&](int x, int y) {
      centre_rays.Fill(x, y, rays);
      lit.tracer().TraceCoherent(rays, hits);
      if (AllMeetOneTriangle(hits)) {
        VisitPlane(lit, centre_rays, {x, y}, hits, visit);
      } else {
        VisitPixels(lit, centre_rays, {x, y}, hits, visit);
      }
    });
  });
}

}  // namespace

GeometryBuffers TraceGeometry(const LitScene& lit, const CentreRays& rays) {
  const int width = rays.camera().width, height = rays.camera().height;
  GeometryBuffers buffers{Image<float>(width, height), Image<Vec3f>(width, height),
                          Image<std::uint32_t>(width, height), Image<std::uint32_t>(width, height)};
  ForEachHit(lit, rays, [&](const HitRun& run, auto length) {
    std::copy_n(run.depth_m, length(), &buffers.depth_m(run.x, run.y));
    std::fill_n(&buffers.normal_camera(run.x, run.y), length(), run.normal_camera);
    std::fill_n(&buffers.instance(run.x, run.y), length(), run.plane.instance);
    std::fill_n(&buffers.material(run.x, run.y), length(), run.plane.material);
  });
  return buffers;
}

Image<float> TraceDepth(const LitScene& lit, const CentreRays& rays) {
  Image<float> depth_m(rays.camera().width, rays.camera().height);
  ForEachHit(lit, rays, [&](const HitRun& run, auto length) {
    std::copy_n(run.depth_m, length(), &depth_m(run.x, run.y));
  });
  return depth_m;
}

}  // namespace silt::sim
