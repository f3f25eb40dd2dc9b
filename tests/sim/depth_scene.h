// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>

#include "noise_statistics.h"
#include "silt/sim/depth_sensor.h"

// Made-up geometry for depth sensors, seen from far away: all rays run along the optical axis.
namespace silt::sim {

inline constexpr PinholeCamera kDepthCamera{1e9, 1e9, 127.5, 127.5, kWidth, kHeight};

// Depth as a function of the pixel, with normals `theta` radians off the axis.
inline GeometryBuffers Geometry(const std::function<double(int x, int y)>& depth_m,
                                double theta = 0) {
  const Vec3f normal{float(std::sin(theta)), 0, float(-std::cos(theta))};
  GeometryBuffers buffers{{kWidth, kHeight}, {kWidth, kHeight, normal}, {}, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) buffers.depth_m(x, y) = float(depth_m(x, y));
  }
  return buffers;
}

inline GeometryBuffers Wall(double depth_m, double theta = 0) {
  return Geometry([depth_m](int, int) { return depth_m; }, theta);
}

inline Image<float> Measured(const DepthSensorOptions& options, const GeometryBuffers& truth,
                             const NoiseKey& key = {7, 2}) {
  return MakeDepthSensor(options)->Measure({kDepthCamera, nullptr, truth}, key);
}

// f of each pixel, away from the border.
inline std::vector<double> Values(const std::function<double(int x, int y)>& f) {
  std::vector<double> values;
  for (int y = 8; y < kHeight - 8; ++y) {
    for (int x = 8; x < kWidth - 8; ++x) values.push_back(f(x, y));
  }
  return values;
}

}  // namespace silt::sim
