// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/residual_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "silt/core/random.h"
#include "silt/tracker/kernel/robust_norm.h"

namespace silt::tracker {
namespace {

constexpr RobustLoss kLosses[] = {RobustLoss::kGemanMcClure, RobustLoss::kHuber, RobustLoss::kTukey,
                                  RobustLoss::kStudentT};

// 2ρ(e) where c is k.
double Square(RobustLoss loss, double e, double k) {
  const double x = e * e / (k * k), inside = std::max(0.0, 1 - x);
  switch (loss) {
    case RobustLoss::kGemanMcClure:
      return e * e / (1 + x);
    case RobustLoss::kHuber:
      return x < 1 ? e * e : 2 * k * std::abs(e) - k * k;
    case RobustLoss::kTukey:
      return k * k / 3 * (1 - inside * inside * inside);
    case RobustLoss::kStudentT:
      return k * k * std::log1p(x);
  }
  return 0;
}

// The expectation as an integral, by the trapezoidal rule.
TEST(MeanRobustSquare, IsTheExpectation) {
  for (const RobustLoss loss : kLosses) {
    for (const double k : {0.1, 0.5, 1.0, 2.5, 10.0, 40.0}) {
      double sum = 0;
      const double step = 1e-3;
      for (double e = -10; e <= 10; e += step) {
        sum += step * Square(loss, e, k) * std::exp(-e * e / 2) / std::sqrt(2 * M_PI);
      }
      EXPECT_NEAR(MeanRobustSquare(loss, k), sum, 2e-4 * sum) << int(loss) << " " << k;
    }
  }
}

// The mean square of `outliers` residuals of size 1 among Gaussian ones.
double MeanOf(RobustLoss loss, double sigma, int outliers, double c) {
  constexpr int kCount = 20000;
  const CounterRandom random(5, 1);
  const kernel::RobustNorm<double> norm{0, c > 0 ? 1 / (c * c) : 0, 1, loss};
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    const double r = i < outliers ? 1.0 : sigma * random.Normal(std::uint64_t(i));
    sum += kernel::Weigh(norm, r, 0.0).s * r * r;
  }
  return sum / kCount;
}

// Of all of them, as the root of their mean square.
double WholeScale(double sigma, int outliers) {
  return ResidualScale(RobustLoss::kGemanMcClure,
                       MeanOf(RobustLoss::kGemanMcClure, sigma, outliers, 0), 0);
}

double IteratedScale(RobustLoss loss, double sigma, int outliers, double k = 2.5) {
  double scale = WholeScale(sigma, outliers);
  for (int i = 0; i < 40; ++i) {
    scale = ResidualScale(loss, MeanOf(loss, sigma, outliers, k * scale), k);
  }
  return scale;
}

TEST(ResidualScale, IsTheStandardDeviationOfGaussianResiduals) {
  // 20,000 draws: a standard error of 0.5 %.
  EXPECT_NEAR(WholeScale(0.01, 0), 0.01, 2e-4);
  for (const RobustLoss loss : kLosses) EXPECT_NEAR(IteratedScale(loss, 0.01, 0), 0.01, 2e-4);
}

TEST(ResidualScale, IsHardlyMovedByOutliers) {
  EXPECT_GT(WholeScale(0.01, 1000), 0.2);
  EXPECT_LT(IteratedScale(RobustLoss::kGemanMcClure, 0.01, 1000), 0.0145);
  EXPECT_LT(IteratedScale(RobustLoss::kTukey, 0.01, 1000, 4.685), 0.0145);
}

// ψ and its slope by differences of ρ, over Gaussian residuals.
TEST(CurvatureLoss, IsHowFarWeightsOverrateTheCurvature) {
  const CounterRandom random(3);
  for (const RobustLoss loss : kLosses) {
    double weights = 0, slopes = 0;
    for (int i = 0; i < 20000; ++i) {
      const double e = random.Normal(std::uint64_t(i)), h = 1e-3;
      const double before = Square(loss, e - h, 2.5), after = Square(loss, e + h, 2.5);
      weights += (after - before) / (4 * h * e);
      slopes += (after - 2 * Square(loss, e, 2.5) + before) / (2 * h * h);
    }
    EXPECT_NEAR(CurvatureLoss(loss, 2.5), weights / slopes, 0.03) << int(loss);
    EXPECT_GT(CurvatureLoss(loss, 2.5), loss == RobustLoss::kHuber ? 1.005 : 1.1) << int(loss);
    EXPECT_NEAR(CurvatureLoss(loss, 1000), 1, 1e-5) << int(loss);
  }
}

}  // namespace
}  // namespace silt::tracker
