// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/vector.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// Irradiance that one unit of the light's radiance makes at a point with unit normal where nothing
// is in between: ∫ cos θ dω over the part of the rectangle above the point's horizon, in [0, π]
// (Lambert 1760: ½ Σ_edges angle(v_i, v_{i+1}) · n·(v_i × v_{i+1})/|v_i × v_{i+1}|). 0 behind the
// light.
double RectangleFormFactor(const RectLight& light, const Vec3d& point, const Vec3d& normal);

}  // namespace silt::sim
