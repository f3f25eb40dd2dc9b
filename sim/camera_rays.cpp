// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_rays.h"

#include <algorithm>

namespace silt::sim {

namespace {

constexpr float kColumn[kPacketSize] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
constexpr float kRow[kPacketSize] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// A coordinate of the directions of a block: exact at its corner, from where float is enough.
void FillCoordinate(double corner, double along_u, double along_v, float* out) {
  const auto c = float(corner), u = float(along_u), v = float(along_v);
  for (int i = 0; i < kPacketSize; ++i) out[i] = c + (kColumn[i] * u + kRow[i] * v);
}

Vec3d Mix(const Vec3d& a, const Vec3d& b, double t) { return a + t * (b - a); }

}  // namespace

CameraRays::CameraRays(const Optics& optics, const SE3d& world_from_camera)
    : width_(optics.camera.width),
      height_(optics.camera.height),
      origin_(world_from_camera.translation),
      lens_(optics.lens) {
  const PinholeCamera& camera = optics.camera;
  const Quaterniond& r = world_from_camera.rotation;
  along_u_ = r * Vec3d{1 / camera.fx, 0, 0};
  along_v_ = r * Vec3d{0, 1 / camera.fy, 0};
  corner_ = r * Vec3d{-camera.cx / camera.fx, -camera.cy / camera.fy, 1};
}

CameraRays::CameraRays(const CameraRays& a, const CameraRays& b, double t)
    : width_(a.width_),
      height_(a.height_),
      origin_(Mix(a.origin_, b.origin_, t)),
      corner_(Mix(a.corner_, b.corner_, t)),
      along_u_(Mix(a.along_u_, b.along_u_, t)),
      along_v_(Mix(a.along_v_, b.along_v_, t)),
      lens_(a.lens_) {}

void CameraRays::Fill(int x, int y, const Vec2d& offset, RayPacket& rays) const {
  if (lens_ != nullptr) {
    for (int i = 0; i < kPacketSize; ++i) {
      const int column = x + i % kBlock, row = y + i / kBlock;
      const bool inside = column < width_ && row < height_;
      FillLane(i, (inside ? column : x) + offset.x, (inside ? row : y) + offset.y, rays);
      if (!inside) rays.valid[i] = 0;
    }
    return;
  }
  const Vec3d direction = Direction(x + offset.x, y + offset.y);
  FillCoordinate(direction.x, along_u_.x, along_v_.x, rays.direction_x);
  FillCoordinate(direction.y, along_u_.y, along_v_.y, rays.direction_y);
  FillCoordinate(direction.z, along_u_.z, along_v_.z, rays.direction_z);
  std::fill_n(rays.origin_x, kPacketSize, float(origin_.x));
  std::fill_n(rays.origin_y, kPacketSize, float(origin_.y));
  std::fill_n(rays.origin_z, kPacketSize, float(origin_.z));
  std::fill_n(rays.near, kPacketSize, 0.0f);
  std::fill_n(rays.far, kPacketSize, RayPacket::kFar);
  const int columns = width_ - x, rows = height_ - y;
  for (int i = 0; i < kPacketSize; ++i) {
    rays.valid[i] = i % kBlock < columns && i / kBlock < rows ? -1 : 0;
  }
}

void CameraRays::FillLane(int lane, double u, double v, RayPacket& rays) const {
  rays.Set(lane, {origin_.Cast<float>(), Direction(u, v).Cast<float>()});
}

}  // namespace silt::sim
