// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/geometry_pass.h"

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

struct CentreHit {
  const SurfacePlane& plane;
  float depth_m;
  Vec3f normal_camera;
};

// Calls visit(x, y, hit) for the pixels of a block that see something.
template <typename Visit>
void VisitBlock(const LitScene& lit, const CentreRays& centre_rays, const Vec2<int>& corner,
                const Visit& visit) {
  RayPacket rays;
  centre_rays.Fill(corner.x, corner.y, rays);
  HitPacket hits;
  lit.tracer().TraceCoherent(rays, hits);
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
    const bool good = z > 0 && z < double(RayPacket::kFar);
    visit(x, y,
          CentreHit{plane, good ? float(z) : hits.distance[i],
                    slope < 0 ? in_view.normal() : -in_view.normal()});
  }
}

// Calls visit(x, y, hit) for every pixel that sees something, in parallel.
template <typename Visit>
void ForEachHit(const LitScene& lit, const CentreRays& rays, const Visit& visit) {
  ForEachTile(rays.camera().width, rays.camera().height, [&](const ImageTile& tile) {
    ForEachBlock(tile, [&](int x, int y) { VisitBlock(lit, rays, {x, y}, visit); });
  });
}

}  // namespace

GeometryBuffers TraceGeometry(const LitScene& lit, const CentreRays& rays) {
  const int width = rays.camera().width, height = rays.camera().height;
  GeometryBuffers buffers{Image<float>(width, height), Image<Vec3f>(width, height),
                          Image<std::uint32_t>(width, height), Image<std::uint32_t>(width, height)};
  ForEachHit(lit, rays, [&](int x, int y, const CentreHit& hit) {
    buffers.depth_m(x, y) = hit.depth_m;
    buffers.normal_camera(x, y) = hit.normal_camera;
    buffers.instance(x, y) = hit.plane.instance;
    buffers.material(x, y) = hit.plane.material;
  });
  return buffers;
}

Image<float> TraceDepth(const LitScene& lit, const CentreRays& rays) {
  Image<float> depth_m(rays.camera().width, rays.camera().height);
  ForEachHit(lit, rays, [&](int x, int y, const CentreHit& hit) { depth_m(x, y) = hit.depth_m; });
  return depth_m;
}

}  // namespace silt::sim
