// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_rays.h"

namespace silt::sim {

CameraRays::CameraRays(const PinholeCamera& camera, const SE3d& world_from_camera,
                       const LensMap* lens)
    : width_(camera.width),
      height_(camera.height),
      origin_(world_from_camera.translation),
      lens_(lens) {
  const Quaterniond& r = world_from_camera.rotation;
  along_u_ = r * Vec3d{1 / camera.fx, 0, 0};
  along_v_ = r * Vec3d{0, 1 / camera.fy, 0};
  corner_ = r * Vec3d{-camera.cx / camera.fx, -camera.cy / camera.fy, 1};
}

void CameraRays::Fill(int x, int y, const Vec2d& offset, RayPacket& rays) const {
  const Vec3f origin = origin_.Cast<float>();
  for (int i = 0; i < kPacketSize; ++i) {
    const int px = x + i % kBlock, py = y + i / kBlock;
    const bool inside = px < width_ && py < height_;
    const Vec3d direction =
        inside || lens_ == nullptr ? Direction(px + offset.x, py + offset.y) : corner_;
    rays.Set(i, {origin, direction.Cast<float>()});
    if (!inside) rays.valid[i] = 0;
  }
}

}  // namespace silt::sim
