// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/trajectory.h"

namespace silt::sim {

// Knots of a cubic spline through keys (two or more) at times t₀ < … < tₙ₋₁: these times, and two
// knots mirrored at either end; t_i stands at i + 2. Mirroring makes the natural end conditions
// trivial: the control poses go on as mirror images too, and the first and last control pose are
// the first and last key pose.
std::vector<double> MirroredKnots(const Trajectory& keys);

// The cumulative cubic B-splines on one interval between knots, as polynomials of the place u in
// [0, 1] within it: λⱼ(u) = Σₖ coefficient[j − 1][k]·uᵏ for j = 1, 2, 3 (λ₀ = 1).
struct CumulativeBasis {
  double coefficient[3][4] = {};

  template <typename T>
  T Lambda(int j, const T& u) const {
    const double* c = coefficient[j - 1];
    return T(c[0]) + u * (T(c[1]) + u * (T(c[2]) + u * T(c[3])));
  }
};

// That of the interval [t[2], t[3]], which six knots determine.
CumulativeBasis MakeCumulativeBasis(const double t[6]);

}  // namespace silt::sim
