// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/sim/lens_map.h"
#include "silt/sim/ray_packet.h"

namespace silt::sim {

// Rays of a camera at one pose. Directions have z = 1 in camera coordinates, so that distances
// along them are depths.
class CameraRays {
 public:
  // Seen through the lens where there is one, which outlives this.
  CameraRays(const PinholeCamera& camera, const SE3d& world_from_camera,
             const LensMap* lens = nullptr);

  int width() const { return width_; }
  int height() const { return height_; }
  const Vec3d& origin() const { return origin_; }
  Vec3d Direction(double u, double v) const {
    if (lens_ == nullptr) return corner_ + u * along_u_ + v * along_v_;
    const Vec2d p = lens_->PinholePixel(u, v);
    return corner_ + p.x * along_u_ + p.y * along_v_;
  }

  // Packets cover blocks of 4 × 4 pixels; lane i is pixel (x + i mod 4, y + i / 4), valid inside
  // the image, sampled `offset` from its centre.
  static constexpr int kBlock = 4;
  void Fill(int x, int y, const Vec2d& offset, RayPacket& rays) const;

 private:
  int width_, height_;
  Vec3d origin_, corner_, along_u_, along_v_;
  const LensMap* lens_;
};

}  // namespace silt::sim
