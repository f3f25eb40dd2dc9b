// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "silt/core/se3.h"

namespace silt::tracker {

// Of a twist ξ = (ω, v), row by row, in rad and m.
using Covariance6 = std::array<double, 36>;

// What an error exp(ξ) in the source's frame is in the target's: Ad·C·Adᵀ, where
// T·exp(ξ)·T⁻¹ = exp(Ad·ξ) with T = target_from_source and Ad = [R 0; [t]ₓR R].
Covariance6 InFrame(const Covariance6& covariance, const SE3d& target_from_source);

// Of two errors, in one frame, that know nothing of each other.
Covariance6 Sum(const Covariance6& a, const Covariance6& b);

// ξᵀ·C⁻¹·ξ, whose mean is 6 for errors that have this covariance; nothing where C has no inverse.
std::optional<double> NormalizedSquare(const Twistd& error, const Covariance6& covariance);

// The largest standard deviation of ξ with its v multiplied by `per_metre`.
double LargestDeviation(const Covariance6& covariance, double per_metre);

}  // namespace silt::tracker
