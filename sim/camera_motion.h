// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/se3.h"
#include "silt/sim/time_jet.h"

namespace silt::sim {

// Where a camera is at one instant and how it moves. An ideal inertial sensor at the camera's
// centre reads angular_velocity and R⁻¹·(acceleration − gravity).
struct CameraMotion {
  SE3d world_from_camera;
  Vec3d velocity;              // of the centre, in world coordinates, m/s
  Vec3d acceleration;          // of the centre, in world coordinates, m/s²
  Vec3d angular_velocity;      // in camera coordinates, rad/s
  Vec3d angular_acceleration;  // its derivative, in camera coordinates, rad/s²

  // ξ = (ω, v) in camera coordinates: d/dt world_from_camera = world_from_camera·[ξ]ₓ.
  Twistd BodyVelocity() const {
    return {angular_velocity, world_from_camera.rotation.Conjugate() * velocity};
  }
};

// For a unit quaternion q = world_from_camera: q̇ = ½·q·ω and q̈ = ½·q·ω̇ − ¼·|ω|²·q, hence
// ω = 2·vec(q⁻¹·q̇) and ω̇ = 2·vec(q⁻¹·q̈).
CameraMotion MotionOf(const SE3<TimeJet>& world_from_camera);

}  // namespace silt::sim
