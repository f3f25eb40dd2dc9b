// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/band_matrix.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

void BandMatrix::Factorize() {
  const int n = int(rows_.size());
  for (int i = 0; i < n; ++i) {
    const int first = std::max(0, i - kBand);
    for (int j = first; j <= i; ++j) {
      double sum = At(i, j);
      for (int k = first; k < j; ++k) sum -= At(i, k) * At(j, k);
      At(i, j) = i == j ? std::sqrt(sum) : sum / At(j, j);
    }
  }
}

// Forward and back substitution: L·y = b, then Lᵀ·x = y.
void BandMatrix::Solve(std::vector<Twistd>& x) const {
  const int n = int(rows_.size());
  const auto subtract = [&x](int to, double factor, int from) {
    Twistd& t = x[std::size_t(to)];
    const Twistd& f = x[std::size_t(from)];
    t = {t.omega - factor * f.omega, t.v - factor * f.v};
  };
  const auto divide = [&](int i) { x[std::size_t(i)] = (1 / Entry(i, i)) * x[std::size_t(i)]; };
  for (int i = 0; i < n; ++i) {
    for (int k = std::max(0, i - kBand); k < i; ++k) subtract(i, Entry(i, k), k);
    divide(i);
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k <= std::min(n - 1, i + kBand); ++k) subtract(i, Entry(k, i), k);
    divide(i);
  }
}

}  // namespace silt::sim
