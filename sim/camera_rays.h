// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/sim/lens_map.h"
#include "silt/sim/ray_packet.h"

namespace silt::sim {

// A camera and the lens before it, if any, which outlives all that is made of it.
struct Optics {
  Optics(const PinholeCamera& pinhole, const LensMap* before = nullptr)
      : camera(pinhole), lens(before) {}

  PinholeCamera camera;
  const LensMap* lens;
};

// Rays of a camera at one pose. Directions have z = 1 in camera coordinates, so that distances
// along them are depths.
class CameraRays {
 public:
  CameraRays() = default;
  CameraRays(const Optics& optics, const SE3d& world_from_camera);
  // Between two poses of one camera that lie close together: t = 0 is a, t = 1 is b. An angle θ
  // between them bends the directions by θ²/8 at most.
  CameraRays(const CameraRays& a, const CameraRays& b, double t);

  int width() const { return width_; }
  int height() const { return height_; }
  const Vec3d& origin() const { return origin_; }
  // What directions are made of: corner + u·along_u + v·along_v for (u, v) = PinholePixel(…).
  const Vec3d& corner() const { return corner_; }
  const Vec3d& along_u() const { return along_u_; }
  const Vec3d& along_v() const { return along_v_; }
  Vec2d PinholePixel(double u, double v) const {
    return lens_ == nullptr ? Vec2d{u, v} : lens_->PinholePixel(u, v);
  }
  Vec3d Direction(double u, double v) const {
    const Vec2d p = PinholePixel(u, v);
    return corner_ + p.x * along_u_ + p.y * along_v_;
  }

  // Packets cover blocks of 4 × 4 pixels; lane i is pixel (x + i mod 4, y + i / 4), valid inside
  // the image, sampled `offset` from its centre.
  static constexpr int kBlock = 4;
  void Fill(int x, int y, const Vec2d& offset, RayPacket& rays) const;
  // One lane: the ray through (u, v).
  void FillLane(int lane, double u, double v, RayPacket& rays) const;

 private:
  int width_ = 0, height_ = 0;
  Vec3d origin_, corner_, along_u_, along_v_;
  const LensMap* lens_ = nullptr;
};

}  // namespace silt::sim
