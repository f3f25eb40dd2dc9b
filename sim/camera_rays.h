// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/se3.h"
#include "silt/sim/ray_packet.h"

namespace silt::sim {

// Rays of a camera at one pose. Directions have z = 1 in camera coordinates, so that distances
// along them are depths.
class CameraRays {
 public:
  CameraRays(const PinholeCamera& camera, const SE3d& world_from_camera);

  const Vec3d& origin() const { return origin_; }
  Vec3d Direction(double u, double v) const { return corner_ + u * along_u_ + v * along_v_; }

  // Packets cover blocks of 4 × 4 pixels; lane i is pixel (x + i mod 4, y + i / 4), valid inside
  // the image, sampled `offset` from its centre.
  static constexpr int kBlock = 4;
  void Fill(int x, int y, const Vec2d& offset, RayPacket& rays) const;

 private:
  int width_, height_;
  Vec3d origin_, corner_, along_u_, along_v_;
};

}  // namespace silt::sim
