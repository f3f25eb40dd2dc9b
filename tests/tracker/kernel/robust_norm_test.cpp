// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/robust_norm.h"

#include <gtest/gtest.h>

namespace silt::tracker::kernel {
namespace {

constexpr RobustNorm<double> kNorm{1 / (0.03 * 0.03), 1 / (0.05 * 0.05)};

double Rho(const RobustNorm<double>& norm, double r, double gradient) {
  return 0.5 * Weigh(norm, r, gradient * gradient).s * r * r;
}

// w·r = dρ/dr, by central differences.
TEST(RobustNorm, TheWeightIsThatOfTheNorm) {
  for (const double gradient : {0.0, 0.01, 0.1}) {
    for (const double r : {-0.3, -0.04, 0.001, 0.05, 0.2}) {
      const double step = 1e-6;
      const double slope =
          (Rho(kNorm, r + step, gradient) - Rho(kNorm, r - step, gradient)) / (2 * step);
      const double root = Weigh(kNorm, r, gradient * gradient).root;
      EXPECT_NEAR(root * root * r, slope, 1e-9) << r << " " << gradient;
    }
  }
}

TEST(RobustNorm, SmallResidualsOnFlatGroundCountAsSquares) {
  EXPECT_NEAR(Rho(kNorm, 1e-4, 0), 0.5e-8, 1e-12);
  EXPECT_NEAR(Weigh(kNorm, 1e-4, 0.0).root, 1, 1e-4);
}

TEST(RobustNorm, WithoutBoundsAllCountAsSquares) {
  const RobustNorm<double> none{0, 0};
  EXPECT_EQ(Rho(none, 0.7, 0.4), 0.5 * 0.7 * 0.7);
  EXPECT_EQ(Weigh(none, 0.7, 0.16).root, 1);
}

// ρ ≤ ½c²: what shows something else cannot outvote the rest, and its pull falls with its size.
TEST(RobustNorm, LargeResidualsAreBounded) {
  EXPECT_LT(Rho(kNorm, 1e3, 0), 0.5 * 0.05 * 0.05);
  const auto pull = [](double r) {
    const double root = Weigh(kNorm, r, 0.0).root;
    return root * root * r;
  };
  EXPECT_GT(pull(0.03), 10 * pull(1.0));
}

TEST(RobustNorm, SteepGradientsCountLess) {
  EXPECT_NEAR(Rho(kNorm, 1e-4, 0.03), 0.25e-8, 1e-12);  // at g: half
}

}  // namespace
}  // namespace silt::tracker::kernel
