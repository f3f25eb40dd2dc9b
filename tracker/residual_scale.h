// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/robust_loss.h"

namespace silt::tracker {

// The scale σ of residuals from the mean of s·r², see kernel/robust_norm.h, that was computed with
// c = `scale_factor`·σ' for an earlier guess σ' of it, or with no c (0): an M-estimate,
// σ² = mean(s·r²)/β, where β makes it the standard deviation of residuals that are Gaussian.
// Repeating it with c = scale_factor·σ converges.
double ResidualScale(RobustLoss loss, double mean_robust_square, double scale_factor);

// E[w]/E[ψ'] of a norm with c = k for a standard normal e, with its weights w and ψ = w·e: by how
// much weighted squares overrate the norm's curvature.
double CurvatureLoss(RobustLoss loss, double k);

// E[s·e²] of a standard normal e, for k > 0: below 1, which it approaches for large k.
double MeanRobustSquare(RobustLoss loss, double k);

}  // namespace silt::tracker
