// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/exposure_rays.h"

namespace silt::sim {

// The rays through the pixels' centres: all from one pose, or, behind a rolling shutter, each row's
// from the pose in the middle of its own exposure.
class CentreRays {
 public:
  CentreRays(const Optics& optics, const SE3d& world_from_camera);
  CentreRays(const Optics& optics, const Shutter& shutter, const PoseAtTime& world_from_camera,
             double time_s);

  const PinholeCamera& camera() const { return optics_.camera; }
  bool rolling() const { return rows_.size() > 1; }
  const CameraRays& OfRow(int y) const {
    return rows_.size() == 1 ? rows_[0] : rows_[std::size_t(y)];
  }
  // camera_from_world, for directions.
  const Mat3d& RotationOfRow(int y) const {
    return rotations_.size() == 1 ? rotations_[0] : rotations_[std::size_t(y)];
  }
  // A block of pixels, see CameraRays::Fill.
  void Fill(int x, int y, RayPacket& rays) const;

 private:
  void AddRow(const SE3d& world_from_camera);

  Optics optics_;
  std::vector<CameraRays> rows_;  // one for all, or one each
  std::vector<Mat3d> rotations_;
};

}  // namespace silt::sim
