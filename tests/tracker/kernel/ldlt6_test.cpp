// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/ldlt6.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "silt/core/random.h"

namespace silt::tracker::kernel {
namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;
using Vector = Eigen::Matrix<double, 6, 1>;

// A sum of `rank` squares whose parts differ in size, so that rows are swapped.
Matrix Semidefinite(const CounterRandom& random, int rank) {
  Matrix a = Matrix::Zero();
  for (int r = 0; r < rank; ++r) {
    Vector v;
    for (int i = 0; i < 6; ++i)
      v[i] = (i % 3 + 1) * (random.Uniform(std::uint64_t(6 * r + i)) - 0.5);
    a += v * v.transpose();
  }
  return a;
}

struct Solution {
  Vector x;
  double least_pivot;
  bool ok;
};

Solution Solve(const Matrix& a, const Vector& b) {
  double matrix[6][6], x[6];
  for (int i = 0; i < 6; ++i) {
    x[i] = b[i];
    for (int j = 0; j < 6; ++j) matrix[i][j] = a(i, j);
  }
  const Ldlt6 ldlt(matrix);
  ldlt.Solve(x);
  return {Eigen::Map<const Vector>(x), ldlt.LeastPivot(), ldlt.ok()};
}

TEST(Ldlt6, SolvesWhatEigenSolves) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const CounterRandom random(seed);
    const Matrix a = Semidefinite(random, 9);
    const Vector b = Semidefinite(CounterRandom(seed + 1000), 1).col(0);
    const Eigen::LDLT<Matrix> eigen(a);
    const Solution solution = Solve(a, b);
    const Vector expected = eigen.solve(b);
    ASSERT_TRUE(solution.ok);
    EXPECT_LE((solution.x - expected).norm(), 1e-12 * expected.norm());
    EXPECT_NEAR(solution.least_pivot, eigen.vectorD().minCoeff(), 1e-14);
    EXPECT_LE((a * solution.x - b).norm(), 1e-9 * (a.norm() * expected.norm() + b.norm()));
  }
}

TEST(Ldlt6, ReadsTheLowerTriangleAlone) {
  Matrix a = Semidefinite(CounterRandom(1), 8);
  const Vector b = a.col(2);
  const Vector x = Solve(a, b).x;
  a(1, 4) = 1e6;
  EXPECT_EQ(Solve(a, b).x, x);
}

// Two directions of which nothing is known: where b has no part along them there is a solution.
TEST(Ldlt6, APivotOfZeroGivesZero) {
  Matrix a = Matrix::Zero();
  a.diagonal() << 2, 0, 4, 8, 0, 1;
  Vector b;
  b << 2, 0, 4, 8, 0, 3;
  Vector expected;
  expected << 1, 0, 1, 1, 0, 3;
  EXPECT_EQ(Solve(a, b).x, expected);
  EXPECT_TRUE(Solve(a, b).ok);
  EXPECT_EQ(Solve(a, b).least_pivot, 0);
}

TEST(Ldlt6, AMatrixWithoutADiagonalHasNoFactors) {
  Matrix a = Matrix::Zero();
  a(1, 0) = 1;
  EXPECT_FALSE(Solve(a, Vector::Ones()).ok);
  EXPECT_TRUE(Solve(Matrix::Zero(), Vector::Ones()).ok);
}

TEST(IsFinite, ExceptForNanAndInfinity) {
  EXPECT_TRUE(IsFinite(-1e308));
  EXPECT_FALSE(IsFinite(1e308 * 10));
  EXPECT_FALSE(IsFinite(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace silt::tracker::kernel
