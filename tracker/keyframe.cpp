// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/keyframe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace silt::tracker {
namespace {

double Distance(const Keyframe& keyframe, const SE3d& world_from_camera,
                const KeyframeOptions& options) {
  const SE3d& other = keyframe.world_from_camera;
  const double metres = Norm(other.translation - world_from_camera.translation);
  if (options.metres_per_radian == 0) return metres;
  const Vec3d turn = (other.rotation.Conjugate() * world_from_camera.rotation).Log();
  return metres + options.metres_per_radian * Norm(turn);
}

// |rx| + |ry| + |rz| of the rotation vector between two cameras, in degrees.
double SummedRotationDeg(const SE3d& world_from_a, const SE3d& world_from_b) {
  const Vec3d r = (world_from_a.rotation.Conjugate() * world_from_b.rotation).Log();
  return (std::abs(r.x) + std::abs(r.y) + std::abs(r.z)) * 180 / 3.14159265358979323846;
}

}  // namespace

KeyframeIds NearestKeyframes(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                             const KeyframeOptions& options, int count) {
  PooledVector<std::pair<double, int>> by_distance;
  by_distance.reserve(keyframes.size());
  for (int i = 0; i < int(keyframes.size()); ++i) {
    by_distance.emplace_back(Distance(keyframes[i], world_from_camera, options), i);
  }
  const std::size_t kept = std::min<std::size_t>(count, by_distance.size());
  std::partial_sort(by_distance.begin(), by_distance.begin() + kept, by_distance.end());
  KeyframeIds nearest;
  for (std::size_t i = 0; i < kept; ++i) {
    if (i > 0 && by_distance[i].first > 3 * options.max_distance_m) break;
    nearest.push_back(by_distance[i].second);
  }
  return nearest;
}

int NearestKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                    const KeyframeOptions& options) {
  SILT_CHECK(!keyframes.empty());
  return NearestKeyframes(keyframes, world_from_camera, options, 1).front();
}

bool NeedsKeyframe(const std::vector<Keyframe>& keyframes, const SE3d& world_from_camera,
                   const KeyframeOptions& options) {
  if (keyframes.empty()) return true;
  const int nearest = NearestKeyframe(keyframes, world_from_camera, options);
  return Distance(keyframes[nearest], world_from_camera, options) > options.max_distance_m ||
         SummedRotationDeg(keyframes.back().world_from_camera, world_from_camera) >
             options.max_rotation_deg;
}

}  // namespace silt::tracker
