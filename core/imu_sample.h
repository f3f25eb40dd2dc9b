// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/se3.h"
#include "silt/core/vector.h"

namespace silt {

// The truth about an inertial sensor at one instant.
struct ImuState {
  SE3d world_from_imu;
  Vec3d velocity;            // in world coordinates, m/s
  Vec3d gyro_bias;           // rad/s, part of the reading
  Vec3d accelerometer_bias;  // m/s², part of the reading
};

// What an inertial sensor reads, in its own axes.
struct ImuSample {
  double time_s = 0;
  Vec3d angular_velocity;  // rad/s
  Vec3d acceleration;      // proper (specific force), m/s²: 9.81 upwards while at rest
  ImuState truth;
};

// White noise of a density and a bias that walks at random, as Kalibr and EuRoC state them.
struct ImuNoise {
  double gyro_density = 0;           // rad/s/√Hz
  double gyro_walk = 0;              // rad/s²/√Hz
  double accelerometer_density = 0;  // m/s²/√Hz
  double accelerometer_walk = 0;     // m/s³/√Hz

  // The ADIS16448 of the EuRoC MAV sequences, by their sensor.yaml.
  static constexpr ImuNoise Euroc() { return {1.6968e-4, 1.9393e-5, 2.0e-3, 3.0e-3}; }
};

// Readings at a constant rate, in order of time.
struct ImuRecording {
  double rate_hz = 0;
  ImuNoise noise;
  std::vector<ImuSample> samples;  // empty: there is no sensor
};

}  // namespace silt
