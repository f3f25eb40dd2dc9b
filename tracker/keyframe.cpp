// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe.h"

#include <cmath>

namespace silt::tracker {
namespace {

double Distance(const Keyframe& keyframe, const SE3d& world_from_camera) {
  return Norm(keyframe.world_from_camera.translation - world_from_camera.translation);
}

// |rx| + |ry| + |rz| of the rotation vector between two cameras, in degrees.
double SummedRotationDeg(const SE3d& world_from_a, const SE3d& world_from_b) {
  const Vec3d r = (world_from_a.rotation.Conjugate() * world_from_b.rotation).Log();
  return (std::abs(r.x) + std::abs(r.y) + std::abs(r.z)) * 180 / 3.14159265358979323846;
}

}  // namespace

int NearestKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera) {
  SILT_CHECK(!keyframes.empty());
  int nearest = 0;
  for (int i = 1; i < int(keyframes.size()); ++i) {
    if (Distance(keyframes[i], world_from_camera) <
        Distance(keyframes[nearest], world_from_camera)) {
      nearest = i;
    }
  }
  return nearest;
}

bool NeedsKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                   const KeyframeOptions& options) {
  if (keyframes.empty()) return true;
  const int nearest = NearestKeyframe(keyframes, world_from_camera);
  return Distance(keyframes[nearest], world_from_camera) > options.max_distance_m ||
         SummedRotationDeg(keyframes.back().world_from_camera, world_from_camera) >
             options.max_rotation_deg;
}

}  // namespace silt::tracker
