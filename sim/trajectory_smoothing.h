// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/trajectory.h"
#include "silt/sim/spline.h"

namespace silt::sim {

struct SmoothingOptions {
  double knot_spacing_s = 0.1;  // of the control poses; faster motion cannot follow
  // τ: a swing of frequency f keeps 1/(1 + (2πfτ)⁴) of its amplitude, hence half at a period of
  // 2πτ. Also what bridges gaps between the poses: the smoothest motion does.
  double smoothing_s = 0.02;
  double max_gap_s = 1;  // poses that are farther apart are refused

  // Throws silt::Error, one line that names the offending value.
  void Validate() const;
};

// How far the measured poses lie from the spline.
struct FitResiduals {
  int poses = 0;
  double rms_m = 0, max_m = 0;
  double rms_deg = 0, max_deg = 0;
};

struct SmoothedTrajectory {
  PoseSpline spline;  // starts at 0, where the first pose was
  FitResiduals residuals;
};

// Fits the control poses C of a cumulative cubic B-spline with even knots to measured poses by
// least squares (P-splines: Eilers and Marx 1996; on rotations the same to first order in the turn
// between neighbours):
//   Σₖ Δt·|rₖ|² + τ⁴·Σᵢ h·|(Cᵢ₋₁ − 2Cᵢ + Cᵢ₊₁)/h²|²,
// with residuals r in metres and radians, the poses' mean spacing Δt and the knots' h; the second
// sum is the integral of the squared acceleration. Throws silt::Error for fewer than two poses, a
// gap, or a fit that does not settle, which takes turns of far more than 90° between knots.
SmoothedTrajectory SmoothTrajectory(const Trajectory& measured, const SmoothingOptions& options);

}  // namespace silt::sim
