// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/imu_sample.h"
#include "silt/sim/camera_path.h"

namespace silt::sim {

struct ImuOptions {
  double rate_hz = 200;
  Vec3d gravity{0, 0, -9.81};  // in world coordinates, m/s²
  ImuNoise noise = {};         // none
  std::uint64_t seed = 0;

  void Validate() const;  // throws silt::Error
};

// What an inertial sensor at the camera's centre, with the camera's axes, reads at the instants
// k/rate_hz from start_s to start_s + duration_s, both included. With the path's exact derivatives,
//   gyro = ω + b_g + n_g,   accelerometer = R⁻¹·(p̈ − g) + b_a + n_a,
// each n of standard deviation density·√rate; each bias b is 0 at time 0 and moves by walk/√rate
// from one reading to the next. Noise and bias depend on the seed and k alone: a stretch reads as
// it does within the whole. Throws silt::Error where the stretch leaves the path.
ImuRecording RecordImu(const CameraPath& path, const ImuOptions& options, double start_s,
                       double duration_s);

}  // namespace silt::sim
