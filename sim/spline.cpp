// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline.h"

#include <algorithm>
#include <string>

#include "silt/core/error.h"
#include "silt/sim/camera_motion.h"
#include "silt/sim/spline_fit.h"

namespace silt::sim {
namespace {

// The control pose beyond `end`, as far from it as its neighbour `inner`: R·exp(−log(R⁻¹·R_inner)).
SE3d MirrorImage(const SE3d& end, const SE3d& inner) {
  return {(end.rotation * inner.rotation.Conjugate() * end.rotation).Normalized(),
          2.0 * end.translation - inner.translation};
}

Twistd Step(const SE3d& from, const SE3d& to) {
  return {(from.rotation.Conjugate() * to.rotation).Log(), to.translation - from.translation};
}

// The motion at time_s, continued at its velocity over the kOvertime_s that begin at start_s.
SplineSegment ConstantVelocity(const CameraMotion& motion, double time_s, double start_s) {
  const double length_s = PoseSpline::kOvertime_s, offset_s = start_s - time_s;
  const SE3d& pose = motion.world_from_camera;
  const Vec3d turned = offset_s * motion.angular_velocity;
  SplineSegment segment;
  segment.start_s = start_s;
  segment.length_s = length_s;
  segment.basis.coefficient[0][1] = 1;  // λ₁ = u
  segment.first = {(pose.rotation * Quaterniond::Exp(turned)).Normalized(),
                   pose.translation + offset_s * motion.velocity};
  segment.step[0] = {length_s * motion.angular_velocity, length_s * motion.velocity};
  return segment;
}

}  // namespace

PoseSpline PoseSpline::Through(const Trajectory& keys) { return WithControls(SolveControls(keys)); }

PoseSpline PoseSpline::WithControls(const Trajectory& controls) {
  const int n = int(controls.size());
  SILT_CHECK(n >= 2);
  for (int i = 1; i < n; ++i) SILT_CHECK(controls[i].time_s > controls[i - 1].time_s);
  const std::vector<double> knots = MirroredKnots(controls);
  const auto given = [&](int i) { return controls[i].world_from_camera; };
  const auto control = [&](int i) {
    if (i < 0) return MirrorImage(given(0), given(1));
    return i < n ? given(i) : MirrorImage(given(n - 1), given(n - 2));
  };
  PoseSpline spline;
  spline.start_s_ = controls.front().time_s;
  spline.end_s_ = controls.back().time_s;
  for (int i = 0; i + 1 < n; ++i) {
    SplineSegment segment;
    segment.start_s = controls[i].time_s;
    segment.length_s = controls[i + 1].time_s - controls[i].time_s;
    segment.first = control(i - 1);
    for (int j = 0; j < 3; ++j) segment.step[j] = Step(control(i - 1 + j), control(i + j));
    segment.basis = MakeCumulativeBasis(&knots[i]);
    spline.segments_.push_back(segment);
  }
  spline.AddOvertime();
  return spline;
}

void PoseSpline::AddOvertime() {
  const auto motion = [](const SplineSegment& segment, double time_s) {
    return MotionOf(segment.At(TimeJet::Time(time_s)));
  };
  const CameraMotion first = motion(segments_.front(), start_s_);
  const CameraMotion last = motion(segments_.back(), end_s_);
  segments_.insert(segments_.begin(), ConstantVelocity(first, start_s_, start_s_ - kOvertime_s));
  segments_.push_back(ConstantVelocity(last, end_s_, end_s_));
}

const SplineSegment& PoseSpline::SegmentAt(double time_s) const {
  const double margin_s = kOvertime_s + 1e-9;
  if (!(time_s >= start_s_ - margin_s && time_s <= end_s_ + margin_s)) {
    throw Error("time " + std::to_string(time_s) +
                " s is outside of the camera path, which lasts from " + std::to_string(start_s_) +
                " to " + std::to_string(end_s_) + " s");
  }
  const auto later = [](double t, const SplineSegment& segment) { return t < segment.start_s; };
  const auto next = std::upper_bound(segments_.begin() + 1, segments_.end(), time_s, later);
  return *(next - 1);
}

}  // namespace silt::sim
