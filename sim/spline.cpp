// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "silt/core/error.h"
#include "silt/sim/camera_motion.h"

namespace silt::sim {
namespace {

// Key times t₀ … tₙ₋₁ with two mirrored knots on either side; knot t_i stands at i + 2. Mirroring
// makes the natural end conditions trivial: the control poses continue as mirror images too, and
// the first and last control poses are the first and last key poses.
std::vector<double> MirroredKnots(const Trajectory& keys) {
  const int n = int(keys.size());
  const auto time = [&](int i) {
    return i < 0 ? 2 * keys[0].time_s - keys[1].time_s
                 : (i < n ? keys[i].time_s : 2 * keys[n - 1].time_s - keys[n - 2].time_s);
  };
  std::vector<double> knots{2 * time(0) - time(2), time(-1)};
  for (const StampedPose& key : keys) knots.push_back(key.time_s);
  knots.push_back(time(n));
  knots.push_back(2 * time(n - 1) - time(n - 3));
  return knots;
}

// The control pose beyond `end`, as far from it as its neighbour `inner`: R·exp(−log(R⁻¹·R_inner)).
SE3d MirrorImage(const SE3d& end, const SE3d& inner) {
  return {(end.rotation * inner.rotation.Conjugate() * end.rotation).Normalized(),
          2.0 * end.translation - inner.translation};
}

// Cumulative basis on [t_i, t_{i+1}] of the cubic B-splines over knots t[0] … t[5] = t_{i−2} …
// t_{i+3}, from the basis matrix of Qin, General matrix representations for B-splines (1998).
void SetCumulativeBasis(const double* t, double lambda[3][4]) {
  const double h = t[3] - t[2];
  const double m00 = h * h / ((t[3] - t[1]) * (t[3] - t[0]));
  const double wide = (t[4] - t[1]) * (t[3] - t[1]);
  const double m02 = (t[2] - t[1]) * (t[2] - t[1]) / wide;
  const double m12 = 3 * h * (t[2] - t[1]) / wide;
  const double m22 = 3 * h * h / wide;
  const double m33 = h * h / ((t[5] - t[2]) * (t[4] - t[2]));
  const double cubic = -m22 / 3 - h * h / ((t[4] - t[2]) * (t[4] - t[1]));
  const double basis[3][4] = {
      {1 - m00, 3 * m00, -3 * m00, m00}, {m02, m12, m22, cubic}, {0, 0, 0, m33}};
  std::copy(&basis[0][0], &basis[0][0] + 12, &lambda[0][0]);
}

Twistd Step(const SE3d& from, const SE3d& to) {
  return {(from.rotation.Conjugate() * to.rotation).Log(), to.translation - from.translation};
}

// From `at_start`, turning at the constant velocity of `motion`.
SplineSegment ConstantVelocity(const CameraMotion& motion, double time_s, double start_s) {
  const double length_s = PoseSpline::kOvertime_s, offset_s = start_s - time_s;
  const SE3d& pose = motion.world_from_camera;
  const Vec3d turned = offset_s * motion.angular_velocity;
  SplineSegment segment{start_s, length_s, {}, {}, {{0, 1, 0, 0}, {}, {}}};
  segment.first = {(pose.rotation * Quaterniond::Exp(turned)).Normalized(),
                   pose.translation + offset_s * motion.velocity};
  segment.step[0] = {length_s * motion.angular_velocity, length_s * motion.velocity};
  return segment;
}

// Interpolation conditions at the inner keys: below·P_{i−1} + (1 − below − above)·P_i +
// above·P_{i+1} = K_i, linear in the positions and, to first order, in small turns of the
// rotations.
struct Condition {
  double below, above;
};

std::vector<Condition> InnerConditions(const std::vector<double>& knots) {
  std::vector<Condition> conditions;
  for (std::size_t i = 1; i + 5 < knots.size(); ++i) {
    double lambda[3][4];
    SetCumulativeBasis(&knots[i], lambda);
    conditions.push_back({1 - lambda[0][0], lambda[1][0]});
  }
  return conditions;
}

// Solves the tridiagonal system of the conditions for the corrections of the inner control poses;
// those of the ends are zero. Elimination needs no pivoting: the matrix is totally positive.
std::vector<Twistd> SolveCorrections(const std::vector<Condition>& conditions,
                                     std::vector<Twistd> residual) {
  const int n = int(conditions.size());
  std::vector<double> upper(n);
  for (int i = 0; i < n; ++i) {
    const auto [below, above] = conditions[i];
    const double pivot = 1 - below - above - (i > 0 ? below * upper[i - 1] : 0);
    upper[i] = above / pivot;
    if (i > 0) {
      residual[i].omega = residual[i].omega - below * residual[i - 1].omega;
      residual[i].v = residual[i].v - below * residual[i - 1].v;
    }
    residual[i] = (1 / pivot) * residual[i];
  }
  for (int i = n - 2; i >= 0; --i) {
    residual[i].omega = residual[i].omega - upper[i] * residual[i + 1].omega;
    residual[i].v = residual[i].v - upper[i] * residual[i + 1].v;
  }
  return residual;
}

// What is missing from the spline to the inner keys: world-side turns and shifts.
std::vector<Twistd> InnerResiduals(const PoseSpline& spline, const Trajectory& keys) {
  std::vector<Twistd> residuals;
  for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
    const SE3d& key = keys[i].world_from_camera;
    const SE3d pose = spline.At(keys[i].time_s);
    residuals.push_back(
        {(key.rotation * pose.rotation.Conjugate()).Log(), key.translation - pose.translation});
  }
  return residuals;
}

double Size(const Twistd& residual) { return std::max(Norm(residual.omega), Norm(residual.v)); }

// The place of the largest residual.
std::size_t Worst(const std::vector<Twistd>& residuals) {
  const auto smaller = [](const Twistd& a, const Twistd& b) { return Size(a) < Size(b); };
  const auto worst = std::max_element(residuals.begin(), residuals.end(), smaller);
  return std::size_t(worst - residuals.begin());
}

double Largest(const std::vector<Twistd>& residuals) {
  return residuals.empty() ? 0 : Size(residuals[Worst(residuals)]);
}

}  // namespace

PoseSpline PoseSpline::WithControls(const Trajectory& controls) {
  const int n = int(controls.size());
  SILT_CHECK(n >= 2);
  for (int i = 1; i < n; ++i) SILT_CHECK(controls[i].time_s > controls[i - 1].time_s);
  const std::vector<double> knots = MirroredKnots(controls);
  const auto control = [&](int i) {
    const auto& pose = [&](int k) -> const SE3d& { return controls[k].world_from_camera; };
    if (i < 0) return MirrorImage(pose(0), pose(1));
    return i < n ? pose(i) : MirrorImage(pose(n - 1), pose(n - 2));
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
    SetCumulativeBasis(&knots[i], segment.lambda);
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

// Newton's method with the constant matrix of the linear problem. A common turn of neighbouring
// control poses turns the spline by as much, so that this matrix is the exact derivative up to the
// curvature of SO(3): positions take one step, rotations gain two digits or so a step.
PoseSpline PoseSpline::Through(const Trajectory& keys) {
  SILT_CHECK(keys.size() >= 2);
  const std::vector<Condition> conditions = InnerConditions(MirroredKnots(keys));
  Trajectory controls = keys;
  PoseSpline spline = WithControls(controls);
  std::vector<Twistd> residuals = InnerResiduals(spline, keys);
  for (int step = 0; step < 100 && Largest(residuals) > 1e-12; ++step) {
    const std::vector<Twistd> corrections = SolveCorrections(conditions, residuals);
    for (std::size_t i = 0; i < corrections.size(); ++i) {
      SE3d& control = controls[i + 1].world_from_camera;
      control.rotation = (Quaterniond::Exp(corrections[i].omega) * control.rotation).Normalized();
      control.translation += corrections[i].v;
    }
    spline = WithControls(controls);
    residuals = InnerResiduals(spline, keys);
  }
  if (!(Largest(residuals) < 1e-9)) {
    const double time_s = keys[Worst(residuals) + 1].time_s;
    throw Error("no spline passes through the key pose at " + std::to_string(time_s) +
                " s: the camera swings too far there; add keys in between");
  }
  return spline;
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
