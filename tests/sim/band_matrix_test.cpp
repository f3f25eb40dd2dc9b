// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/band_matrix.h"

#include <gtest/gtest.h>

#include "silt/core/random.h"

namespace silt::sim {
namespace {

// L·Lᵀ of a random lower band matrix with a strong diagonal: symmetric, positive definite, banded.
std::vector<std::vector<double>> RandomDense(int n) {
  const CounterRandom random(3);
  std::vector<std::vector<double>> l(n, std::vector<double>(n)), a = l;
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - BandMatrix::kBand); j <= i; ++j) {
      l[i][j] = i == j ? 2 + random.Uniform(i) : random.Normal(std::uint64_t(100 + i * n + j)) / 2;
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) a[i][j] += l[i][k] * l[j][k];
    }
  }
  return a;
}

TEST(BandMatrix, SolvesWhatTheDenseProductGives) {
  for (const int n : {1, 2, 3, 4, 20}) {
    const auto dense = RandomDense(n);
    BandMatrix matrix(n);
    std::vector<Twistd> expected, x(n);
    for (int i = 0; i < n; ++i) {
      for (int j = std::max(0, i - BandMatrix::kBand); j <= i; ++j) matrix.At(i, j) = dense[i][j];
      expected.push_back({{1.0 + i, -2, 0.5 * i}, {0.1, 3, double(-i)}});
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        x[i].omega += dense[i][j] * expected[j].omega;
        x[i].v += dense[i][j] * expected[j].v;
      }
    }
    matrix.Factorize();
    matrix.Solve(x);
    for (int i = 0; i < n; ++i) {
      EXPECT_LT(Norm(x[i].omega - expected[i].omega), 1e-11) << n;
      EXPECT_LT(Norm(x[i].v - expected[i].v), 1e-11) << n;
    }
  }
}

}  // namespace
}  // namespace silt::sim
