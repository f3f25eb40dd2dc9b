// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "silt/core/raw_sequence.h"

namespace silt::dense {

inline constexpr PinholeCamera kSmallCamera{96, 95, 47.5, 35.5, 96, 72};

// A camera that moves before a wall of waves in colour, 2 m away.
inline std::vector<RawFrame> Waves(int count) {
  std::vector<RawFrame> frames;
  for (int i = 0; i < count; ++i) {
    RawFrame raw;
    raw.camera = kSmallCamera;
    raw.world_from_camera =
        SE3d::Exp({{0.002 * i, 0.004 * i, 0.001 * i}, {0.01 * i, 0, 0.005 * i}});
    raw.frame.time_s = 0.05 * i;
    raw.frame.rgb = Image<Rgb8>(kSmallCamera.width, kSmallCamera.height);
    raw.frame.depth_m = Image<float>(kSmallCamera.width, kSmallCamera.height);
    const Vec3d eye = raw.world_from_camera.translation;
    for (int y = 0; y < kSmallCamera.height; ++y) {
      for (int x = 0; x < kSmallCamera.width; ++x) {
        const Vec3d ray = raw.world_from_camera.rotation * kSmallCamera.Unproject(x, y, 1.0);
        const double t = (2 - eye.z) / ray.z;
        const Vec3d p = eye + t * ray;
        const double value = 128 + 50 * std::sin(9 * p.x + 2 * p.y) + 50 * std::cos(8 * p.y);
        raw.frame.rgb(x, y) = {std::uint8_t(value), std::uint8_t(value), std::uint8_t(value)};
        raw.frame.depth_m(x, y) = float(t);
      }
    }
    frames.push_back(raw);
  }
  return frames;
}

}  // namespace silt::dense
