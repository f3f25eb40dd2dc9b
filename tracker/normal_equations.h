// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace silt::tracker {

// Cost over the pixels that a pose lets both images see. Intensities are in [0, 1].
struct PhotometricCost {
  double sum = 0;           // ½ Σ r², the paper's cost (eq. 8)
  std::int64_t pixels = 0;  // how many residuals there are

  // The cost by which poses are compared: a sum also falls by losing pixels.
  double mean() const { return pixels > 0 ? sum / double(pixels) : 0; }
  bool operator==(const PhotometricCost&) const = default;
};

// Sums over pixels for eq. 17; parameters in the order ξ = (ω, v).
struct NormalEquations {
  std::array<double, 21> hessian{};  // JᵀJ, its upper triangle row by row
  std::array<double, 6> gradient{};  // Jᵀr
  PhotometricCost cost;
  bool operator==(const NormalEquations&) const = default;
};

}  // namespace silt::tracker
