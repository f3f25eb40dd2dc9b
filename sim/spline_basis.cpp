// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline_basis.h"

namespace silt::sim {

std::vector<double> MirroredKnots(const Trajectory& keys) {
  const int n = int(keys.size());
  const auto time = [&](int i) {
    if (i < 0) return 2 * keys[0].time_s - keys[1].time_s;
    return i < n ? keys[i].time_s : 2 * keys[n - 1].time_s - keys[n - 2].time_s;
  };
  std::vector<double> knots{2 * time(0) - time(2), time(-1)};
  for (const StampedPose& key : keys) knots.push_back(key.time_s);
  knots.push_back(time(n));
  knots.push_back(2 * time(n - 1) - time(n - 3));
  return knots;
}

// From the basis matrix of Qin, General matrix representations for B-splines (1998).
CumulativeBasis MakeCumulativeBasis(const double t[6]) {
  const double h = t[3] - t[2];
  const double m00 = h * h / ((t[3] - t[1]) * (t[3] - t[0]));
  const double wide = (t[4] - t[1]) * (t[3] - t[1]);
  const double m02 = (t[2] - t[1]) * (t[2] - t[1]) / wide;
  const double m12 = 3 * h * (t[2] - t[1]) / wide;
  const double m22 = 3 * h * h / wide;
  const double m33 = h * h / ((t[5] - t[2]) * (t[4] - t[2]));
  const double cubic = -m22 / 3 - h * h / ((t[4] - t[2]) * (t[4] - t[1]));
  return {{{1 - m00, 3 * m00, -3 * m00, m00}, {m02, m12, m22, cubic}, {0, 0, 0, m33}}};
}

}  // namespace silt::sim
