// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/trajectory.h"

namespace silt::sim {

// The control poses with which PoseSpline::WithControls passes through the keys (two or more, times
// increasing) to 1e-9 m and rad. Throws silt::Error that names the key where it does not.
Trajectory SolveControls(const Trajectory& keys);

}  // namespace silt::sim
