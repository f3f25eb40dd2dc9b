// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/normal_equations.h"

namespace silt::tracker {

// The scale σ of residuals whose cost was computed with c = `scale_factor`·σ' for an earlier guess
// σ' of it, or with no c (0): an M-estimate, σ² = mean(s·r²)/β, where β makes it the standard
// deviation of residuals that are Gaussian. Repeating it with c = scale_factor·σ converges.
double ResidualScale(const PhotometricCost& cost, double scale_factor);

// E[e²/(1 + e²/k²)] of a standard normal e, for k > 0: below 1, which it approaches for large k.
double MeanRobustSquare(double k);

}  // namespace silt::tracker
