// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "silt/core/host_device.h"

namespace silt::tracker::kernel {

// Not NaN and not infinite.
SILT_HOST_DEVICE inline bool IsFinite(double x) { return x - x == 0; }

// A symmetric 6×6 matrix A = Pᵀ·L·D·Lᵀ·P, where P brings the largest of the remaining pivots up at
// each step. It serves matrices that are semidefinite too. Step by step the operations are those of
// Eigen 3.4's LDLT (cf. its ldlt_inplace), so that the results have its bits.
class Ldlt6 {
 public:
  // Reads the lower triangle of `a`.
  SILT_HOST_DEVICE explicit Ldlt6(const double (&a)[6][6]) {
    SILT_UNROLL for (int i = 0; i < 6; ++i) {
      SILT_UNROLL for (int j = 0; j < 6; ++j) m_[i][j] = j <= i ? a[i][j] : 0;
    }
    SILT_UNROLL for (int k = 0; k < 6; ++k) Eliminate(k);
  }

  // False where a pivot of 0 has others, or elements that are not 0, after it.
  SILT_HOST_DEVICE bool ok() const { return ok_; }

  SILT_HOST_DEVICE double LeastPivot() const {
    double least = m_[0][0];
    SILT_UNROLL for (int i = 1; i < 6; ++i) least = m_[i][i] < least ? m_[i][i] : least;
    return least;
  }

  // x ← A⁻¹·x; along a pivot of 0, 0.
  SILT_HOST_DEVICE void Solve(double (&x)[6]) const {
    SILT_UNROLL for (int k = 0; k < 6; ++k) SwapElements(k, x);
    SILT_UNROLL for (int i = 1; i < 6; ++i) x[i] -= SumBefore(i, x);
    SILT_UNROLL for (int i = 0; i < 6; ++i) {
      x[i] = std::abs(m_[i][i]) > std::numeric_limits<double>::min() ? x[i] / m_[i][i] : 0;
    }
    SILT_UNROLL for (int i = 4; i >= 0; --i) x[i] -= SumAfter(i, x);
    SILT_UNROLL for (int k = 5; k >= 0; --k) SwapElements(k, x);
  }

 private:
  SILT_HOST_DEVICE static void Swap(double& a, double& b) {
    const double kept = a;
    a = b;
    b = kept;
  }

  // Brings the largest diagonal element from k on to k.
  SILT_HOST_DEVICE void Pivot(int k) {
    int largest = k;
    double most = std::abs(m_[k][k]);
    SILT_UNROLL for (int i = k + 1; i < 6; ++i) {
      const bool larger = std::abs(m_[i][i]) > most;
      largest = larger ? i : largest;
      most = larger ? std::abs(m_[i][i]) : most;
    }
    swapped_[k] = largest;
    SILT_UNROLL for (int i = k + 1; i < 6; ++i) {
      if (i == largest) SwapRows(k, i);
    }
  }

  // And columns, for k < p, in the lower triangle.
  SILT_HOST_DEVICE void SwapRows(int k, int p) {
    SILT_UNROLL for (int j = 0; j < k; ++j) Swap(m_[k][j], m_[p][j]);
    SILT_UNROLL for (int i = p + 1; i < 6; ++i) Swap(m_[i][k], m_[i][p]);
    Swap(m_[k][k], m_[p][p]);
    SILT_UNROLL for (int i = k + 1; i < p; ++i) Swap(m_[i][k], m_[p][i]);
  }

  SILT_HOST_DEVICE void Eliminate(int k) {
    Pivot(k);
    double scaled[6];
    SILT_UNROLL for (int j = 0; j < k; ++j) scaled[j] = m_[j][j] * m_[k][j];
    SILT_UNROLL for (int i = k; i < 6; ++i) {
      double sum = 0;
      SILT_UNROLL for (int j = 0; j < k; ++j) sum += m_[i][j] * scaled[j];
      m_[i][k] -= sum;
    }
    const double pivot = m_[k][k];
    const bool zero = !(std::abs(pivot) > 0);
    ok_ = ok_ && !(found_zero_ && !zero);
    found_zero_ = found_zero_ || zero;
    SILT_UNROLL for (int i = k + 1; i < 6; ++i) {
      ok_ = ok_ && (!zero || m_[i][k] == 0);
      m_[i][k] = zero ? m_[i][k] : m_[i][k] / pivot;
    }
  }

  SILT_HOST_DEVICE void SwapElements(int k, double (&x)[6]) const {
    SILT_UNROLL for (int i = k + 1; i < 6; ++i) {
      if (i == swapped_[k]) Swap(x[k], x[i]);
    }
  }

  // Σ L_ij·x_j over j < i.
  SILT_HOST_DEVICE double SumBefore(int i, const double (&x)[6]) const {
    const auto at = [&](int j) { return m_[i][j] * x[j]; };
    switch (i) {
      case 1:
        return at(0);
      case 2:
        return at(0) + at(1);
      case 3:
        return at(0) + (at(1) + at(2));
      case 4:
        return (at(0) + at(1)) + (at(2) + at(3));
      default:
        return (at(0) + at(1)) + (at(2) + (at(3) + at(4)));
    }
  }

  // Σ L_ji·x_j over j > i.
  SILT_HOST_DEVICE double SumAfter(int i, const double (&x)[6]) const {
    const auto at = [&](int j) { return m_[j][i] * x[j]; };
    switch (i) {
      case 4:
        return at(5);
      case 3:
        return at(4) + at(5);
      case 2:
        return (at(3) + at(4)) + at(5);
      case 1:
        return (at(2) + at(4)) + (at(3) + at(5));
      default:
        return ((at(1) + at(3)) + (at(2) + at(4))) + at(5);
    }
  }

  double m_[6][6];  // L below the diagonal, D on it
  int swapped_[6];  // row k with this one, which is not above it
  bool ok_ = true, found_zero_ = false;
};

}  // namespace silt::tracker::kernel
