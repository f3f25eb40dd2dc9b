// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "silt/core/se3.h"

namespace silt::sim {

// A symmetric positive definite n×n matrix of which only the diagonal and the kBand places beside
// it may differ from zero: what couples the control poses of a cubic spline.
class BandMatrix {
 public:
  static constexpr int kBand = 3;

  explicit BandMatrix(int n) : rows_(std::size_t(n)) {}

  // The entry (row, column) of the lower half: column ≤ row ≤ column + kBand.
  double& At(int row, int column) { return rows_[std::size_t(row)][std::size_t(row - column)]; }

  // Replaces the matrix by its Cholesky factor L, L·Lᵀ being the matrix. Entries that are not
  // finite follow where it was not positive definite.
  void Factorize();

  // Replaces the right side by the solution; after Factorize().
  void Solve(std::vector<Twistd>& right_side) const;

 private:
  double Entry(int row, int column) const {
    return rows_[std::size_t(row)][std::size_t(row - column)];
  }

  std::vector<std::array<double, kBand + 1>> rows_;  // each from the diagonal to the left
};

}  // namespace silt::sim
