// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// The scale σ of residuals from the mean of s·r², see kernel/robust_norm.h, that was computed with
// c = `scale_factor`·σ' for an earlier guess σ' of it, or with no c (0): an M-estimate,
// σ² = mean(s·r²)/β, where β makes it the standard deviation of residuals that are Gaussian.
// Repeating it with c = scale_factor·σ converges.
double ResidualScale(double mean_robust_square, double scale_factor);

// E[w]/E[ψ'] of Geman-McClure's norm with c = k for a standard normal e, with w = 1/(1 + e²/k²)²
// and ψ = w·e: by how much weighted squares overrate the norm's curvature.
double CurvatureLoss(double k);

// E[e²/(1 + e²/k²)] of a standard normal e, for k > 0: below 1, which it approaches for large k.
double MeanRobustSquare(double k);

}  // namespace silt::tracker
