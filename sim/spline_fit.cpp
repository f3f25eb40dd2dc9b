// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline_fit.h"

#include <algorithm>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/sim/spline.h"

namespace silt::sim {
namespace {

// Interpolation conditions at the inner keys: below·P_{i−1} + (1 − below − above)·P_i +
// above·P_{i+1} = K_i, linear in the positions and, to first order, in small turns of the
// rotations.
struct Condition {
  double below, above;
};

std::vector<Condition> InnerConditions(const Trajectory& keys) {
  const std::vector<double> knots = MirroredKnots(keys);
  std::vector<Condition> conditions;
  for (std::size_t i = 1; i + 5 < knots.size(); ++i) {
    const CumulativeBasis basis = MakeCumulativeBasis(&knots[i]);
    conditions.push_back({1 - basis.Lambda(1, 0.0), basis.Lambda(2, 0.0)});
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
std::vector<Twistd> InnerResiduals(const Trajectory& controls, const Trajectory& keys) {
  const PoseSpline spline = PoseSpline::WithControls(controls);
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

// Newton's method with the constant matrix of the linear problem. A common turn of neighbouring
// control poses turns the spline by as much, so that this matrix is the exact derivative up to the
// curvature of SO(3): positions take one step, rotations gain two digits or so a step.
Trajectory SolveControls(const Trajectory& keys) {
  SILT_CHECK(keys.size() >= 2);
  const std::vector<Condition> conditions = InnerConditions(keys);
  Trajectory controls = keys;
  std::vector<Twistd> residuals = InnerResiduals(controls, keys);
  for (int step = 0; step < 100 && Largest(residuals) > 1e-12; ++step) {
    const std::vector<Twistd> corrections = SolveCorrections(conditions, residuals);
    for (std::size_t i = 0; i < corrections.size(); ++i) {
      SE3d& control = controls[i + 1].world_from_camera;
      control.rotation = (Quaterniond::Exp(corrections[i].omega) * control.rotation).Normalized();
      control.translation += corrections[i].v;
    }
    residuals = InnerResiduals(controls, keys);
  }
  if (!(Largest(residuals) < 1e-9)) {
    const double time_s = keys[Worst(residuals) + 1].time_s;
    throw Error("no spline passes through the key pose at " + std::to_string(time_s) +
                " s: the camera swings too far there; add keys in between");
  }
  return controls;
}

}  // namespace silt::sim
