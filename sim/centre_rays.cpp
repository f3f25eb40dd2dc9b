// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/centre_rays.h"

namespace silt::sim {

CentreRays::CentreRays(const Optics& optics, const SE3d& world_from_camera) : optics_(optics) {
  AddRow(world_from_camera);
}

CentreRays::CentreRays(const Optics& optics, const Shutter& shutter,
                       const PoseAtTime& world_from_camera, double time_s)
    : optics_(optics) {
  if (shutter.row_time_s == 0) {
    AddRow(world_from_camera(time_s));
    return;
  }
  for (int y = 0; y < optics.camera.height; ++y) {
    AddRow(world_from_camera(time_s + shutter.RowTime(y, optics.camera.height)));
  }
}

void CentreRays::AddRow(const SE3d& world_from_camera) {
  rows_.emplace_back(optics_, world_from_camera);
  rotations_.push_back(Transposed(world_from_camera.rotation.Matrix()));
}

void CentreRays::Fill(int x, int y, RayPacket& rays) const {
  if (rows_.size() == 1) {
    rows_[0].Fill(x, y, {}, rays);
    return;
  }
  for (int i = 0; i < kPacketSize; ++i) {
    const int column = x + i % CameraRays::kBlock, row = y + i / CameraRays::kBlock;
    const bool inside = column < optics_.camera.width && row < optics_.camera.height;
    OfRow(inside ? row : y).FillLane(i, inside ? column : x, inside ? row : y, rays);
    if (!inside) rays.valid[i] = 0;
  }
}

}  // namespace silt::sim
