// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/se3.h"
#include "silt/core/trajectory.h"
#include "silt/sim/spline_basis.h"
#include "silt/sim/time_jet.h"

namespace silt::sim {

// The plain number in a scalar that carries derivatives.
inline double PlainValue(double x) { return x; }
inline double PlainValue(const TimeJet& x) { return x.value; }
template <typename Jet>
double PlainValue(const Jet& x) {
  return x.a;  // ceres::Jet
}

// One stretch [start_s, start_s + length_s] of a cumulative cubic B-spline, u = (t − start)/length:
//   p(t) = p₀ + Σⱼ λⱼ(u)·Δⱼ,   R(t) = R₀·Πⱼ exp(λⱼ(u)·dⱼ),   j = 1, 2, 3,
// with Δⱼ = pⱼ − pⱼ₋₁ and dⱼ = log(Rⱼ₋₁⁻¹·Rⱼ) between its four control poses.
struct SplineSegment {
  double start_s = 0, length_s = 1;
  SE3d first;      // (R₀, p₀)
  Twistd step[3];  // (dⱼ, Δⱼ)
  CumulativeBasis basis;

  template <typename T>
  SE3<T> At(const T& time_s) const {
    const T u = (time_s - T(start_s)) / T(length_s);
    SE3<T> pose = first.Cast<T>();
    for (int j = 1; j <= 3; ++j) {
      const T lambda = basis.Lambda(j, u);
      const Twistd& s = step[j - 1];
      pose.translation += lambda * s.v.Cast<T>();
      pose.rotation = pose.rotation * Quaternion<T>::Exp(lambda * s.omega.Cast<T>());
    }
    pose.rotation = pose.rotation.Normalized();
    return pose;
  }
};

// Twice continuously differentiable motion: a cumulative cubic B-spline (Lovegrove et al. 2013;
// Sommer et al. 2020) on SO(3) × R³. Rotation and position are blended apart, because on SE(3) they
// move along screws: a camera that turns while it walks a straight line would leave the line.
//
// Knots lie at the key times, which may be uneven; beyond the ends they are mirrored. The ends are
// natural (no acceleration), and the motion goes on at constant velocity for kOvertime_s before the
// first and after the last key, still C²: a shutter centred on the first frame opens before it.
// A rigid motion of all keys moves the spline with them. Between two keys the rotation takes the
// shorter way, whatever the signs of the quaternions. Like any interpolating cubic, the spline
// overshoots where a long and a short interval meet: space the keys evenly along the path.
class PoseSpline {
 public:
  static constexpr double kOvertime_s = 0.1;

  // The spline that passes through the keys (at least 2, times increasing) to 1e-9 m and rad: its
  // control poses are solved for. Throws silt::Error where that fails, which takes keys that swing
  // to and fro by more than some 50°: the control poses then lie half a turn apart.
  static PoseSpline Through(const Trajectory& keys);

  // The spline whose control poses are given. It cuts the corners: a path drawn through key poses
  // shrinks.
  static PoseSpline WithControls(const Trajectory& controls);

  // Times of the first and the last key.
  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }

  // world_from_camera at start_s − kOvertime_s ≤ time ≤ end_s + kOvertime_s; silt::Error elsewhere.
  // T: double, TimeJet or ceres::Jet.
  template <typename T>
  SE3<T> At(const T& time_s) const {
    return SegmentAt(PlainValue(time_s)).At(time_s);
  }

 private:
  void AddOvertime();
  const SplineSegment& SegmentAt(double time_s) const;

  std::vector<SplineSegment> segments_;  // the first and the last are the overtime
  double start_s_ = 0, end_s_ = 0;
};

}  // namespace silt::sim
