// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/se3.h"
#include "silt/core/trajectory.h"
#include "silt/sim/camera_motion.h"
#include "silt/sim/hand_shake.h"
#include "silt/sim/spline.h"
#include "silt/sim/trajectory_smoothing.h"

namespace silt::sim {

// How far and how fast a path moves, measured between samples 1 ms apart, accelerations 5 ms (a
// million samples at most, on paths of hours).
struct PathStatistics {
  double duration_s = 0;
  double length_m = 0;
  double mean_speed_m_s = 0, max_speed_m_s = 0;
  double mean_turn_deg_s = 0, max_turn_deg_s = 0;
  double mean_acceleration_m_s2 = 0, max_acceleration_m_s2 = 0;
  double max_turn_acceleration_deg_s2 = 0;
  Vec3d lowest, highest;  // corners of the box that holds all positions, in world coordinates
};

// The instants k/fps, exactly that quotient, with start_s ≤ k/fps < start_s + duration_s: frames of
// a stretch are frames of the whole. Throws silt::Error unless fps and duration_s are positive and
// start_s is not negative.
std::vector<double> FrameTimes(double fps, double start_s, double duration_s);

// Where a camera is at every time from 0 to duration_s(): a spline, then the shake of the hand that
// holds it: p = p_spline + displacement, R = R_spline·exp(rotation). Twice continuously
// differentiable; it answers PoseSpline::kOvertime_s beyond either end, so that a shutter may be
// open there, and throws silt::Error farther out.
class CameraPath {
 public:
  // The spline must start at time 0. `fit` tells how far it is from the poses that it replays.
  explicit CameraPath(PoseSpline spline, HandShake shake = {},
                      std::optional<FitResiduals> fit = {});

  double duration_s() const { return spline_.end_s(); }
  // Without the shake: what passes through the key poses.
  const PoseSpline& spline() const { return spline_; }
  // Of a replayed trajectory only.
  const std::optional<FitResiduals>& fit() const { return fit_; }

  SE3d WorldFromCamera(double time_s) const { return At(time_s); }
  CameraMotion Motion(double time_s) const { return MotionOf(At(TimeJet::Time(time_s))); }
  // ξ = (ω, v) in camera coordinates, rad/s and m/s.
  Twistd BodyVelocity(double time_s) const { return Motion(time_s).BodyVelocity(); }

  // In metres, at 1 kHz.
  double LengthM() const { return Statistics().length_m; }
  PathStatistics Statistics() const;

  // The poses at FrameTimes(…). Throws silt::Error where these reach beyond the path.
  Trajectory Sample(double fps, double start_s, double duration_s) const;
  Trajectory Sample(double fps) const { return Sample(fps, 0, duration_s()); }

  // world_from_camera for T = double, TimeJet or ceres::Jet.
  template <typename T>
  SE3<T> At(const T& time_s) const {
    SE3<T> pose = spline_.At(time_s);
    pose.translation += shake_.Displacement(time_s);
    pose.rotation = (pose.rotation * Quaternion<T>::Exp(shake_.Rotation(time_s))).Normalized();
    return pose;
  }

 private:
  void AddAccelerations(PathStatistics& statistics) const;

  PoseSpline spline_;
  HandShake shake_;
  std::optional<FitResiduals> fit_;
};

}  // namespace silt::sim
