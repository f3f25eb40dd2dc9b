// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/random.h"
#include "silt/core/trajectory.h"

namespace silt::sim {

// A random walk of key poses: steps of some 0.3 m and at most `turn_rad`, 0.3 to 1.7 s apart.
inline Trajectory RandomKeys(int count, double turn_rad = 0.8, std::uint64_t seed = 1) {
  const CounterRandom random(seed);
  Trajectory keys{{0, SE3d::Exp({{0.3, -2, 0.5}, {1, 2, 3}})}};
  for (int i = 1; i < count; ++i) {
    const auto normal = [&](int k) { return random.Normal(std::uint64_t(8 * i + k)); };
    const Vec3d axis = Normalized(Vec3d{normal(0), normal(1), normal(2)});
    const double turn = turn_rad * random.Uniform(std::uint64_t(1000000 + i));
    const SE3d& last = keys.back().world_from_camera;
    const SE3d next{last.rotation * Quaterniond::Exp(turn * axis),
                    last.translation + 0.3 * Vec3d{normal(3), normal(4), normal(5)}};
    const double pause_s = 0.3 + 1.4 * random.Uniform(std::uint64_t(2000000 + i));
    keys.push_back({keys.back().time_s + pause_s, next});
  }
  return keys;
}

// Of two poses: metres and radians apart, the larger.
inline double PoseDistance(const SE3d& a, const SE3d& b) {
  return std::max(Norm(a.translation - b.translation),
                  RotationAngle(a.rotation.Conjugate() * b.rotation));
}

}  // namespace silt::sim
