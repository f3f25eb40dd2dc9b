// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/robust_norm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::tracker::kernel {
namespace {

constexpr RobustNorm<double> kNorm{1 / (0.03 * 0.03), 1 / (0.05 * 0.05)};

double Rho(const RobustNorm<double>& norm, double r, double gradient) {
  return 0.5 * Weigh(norm, r, gradient * gradient).s * r * r;
}

// w·r = dρ/dr, by central differences, within and beyond c.
TEST(RobustNorm, TheWeightIsThatOfTheNorm) {
  for (const RobustLoss loss :
       {RobustLoss::kGemanMcClure, RobustLoss::kHuber, RobustLoss::kTukey, RobustLoss::kStudentT}) {
    RobustNorm<double> norm = kNorm;
    norm.loss = loss;
    for (const double gradient : {0.0, 0.01, 0.1}) {
      for (const double r : {-0.3, -0.04, 0.001, 0.051, 0.2}) {
        const double step = 1e-6;
        const double slope =
            (Rho(norm, r + step, gradient) - Rho(norm, r - step, gradient)) / (2 * step);
        const double root = Weigh(norm, r, gradient * gradient).root;
        EXPECT_NEAR(root * root * r, slope, 1e-7) << int(loss) << " " << r << " " << gradient;
      }
    }
    EXPECT_NEAR(Rho(norm, 1e-6, 0), 0.5e-12, 1e-16) << int(loss);
    EXPECT_EQ(Rho(norm, 0, 0), 0) << int(loss);
  }
}

TEST(RobustNorm, LogarithmsComeOfRoots) {
  EXPECT_EQ(LogShare(0.0), 1);
  for (const double x : {1e-9, 0.01, 0.5, 3.0, 100.0, 1e4}) {
    EXPECT_NEAR(LogShare(x), std::log1p(x) / x, 1e-5 * std::log1p(x) / x) << x;
    EXPECT_NEAR(LogShare(float(x)), std::log1p(x) / x, 1e-5 * std::log1p(x) / x) << x;
  }
}

// Of one outlier: bounded, or growing with it or with its logarithm.
TEST(RobustNorm, OutliersCountAsTheirNormSays) {
  const auto rho = [](RobustLoss loss, double r) {
    return Rho({0, 1 / (0.05 * 0.05), 1, loss}, r, 0) / (0.05 * 0.05);
  };
  EXPECT_NEAR(rho(RobustLoss::kHuber, 5), 99.5, 1e-9);
  EXPECT_NEAR(rho(RobustLoss::kTukey, 5), 1.0 / 6, 1e-12);
  EXPECT_NEAR(rho(RobustLoss::kStudentT, 5), 0.5 * std::log(10001.0), 1e-4);
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
