// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/residual_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/random.h"
#include "silt/tracker/kernel/robust_norm.h"

namespace silt::tracker {
namespace {

// The expectation as an integral, by the trapezoidal rule.
TEST(MeanRobustSquare, IsTheExpectation) {
  for (const double k : {0.5, 1.0, 2.5, 10.0, 19.9, 20.1, 40.0}) {
    double sum = 0;
    const double step = 1e-3;
    for (double e = -10; e <= 10; e += step) {
      sum += step * e * e / (1 + e * e / (k * k)) * std::exp(-e * e / 2) / std::sqrt(2 * M_PI);
    }
    EXPECT_NEAR(MeanRobustSquare(k), sum, 2e-5) << k;
  }
}

// The mean square of `outliers` residuals of size 1 among Gaussian ones.
double MeanOf(double sigma, int outliers, double c) {
  constexpr int kCount = 20000;
  const CounterRandom random(5, 1);
  const kernel::RobustNorm<double> norm{0, c > 0 ? 1 / (c * c) : 0};
  double sum = 0;
  for (int i = 0; i < kCount; ++i) {
    const double r = i < outliers ? 1.0 : sigma * random.Normal(std::uint64_t(i));
    sum += kernel::Weigh(norm, r, 0.0).s * r * r;
  }
  return sum / kCount;
}

double IteratedScale(double sigma, int outliers) {
  double scale = ResidualScale(MeanOf(sigma, outliers, 0), 0);
  for (int i = 0; i < 20; ++i) scale = ResidualScale(MeanOf(sigma, outliers, 2.5 * scale), 2.5);
  return scale;
}

TEST(ResidualScale, IsTheStandardDeviationOfGaussianResiduals) {
  // 20,000 draws: a standard error of 0.5 %.
  EXPECT_NEAR(ResidualScale(MeanOf(0.01, 0, 0), 0), 0.01, 2e-4);
  EXPECT_NEAR(IteratedScale(0.01, 0), 0.01, 2e-4);
}

TEST(ResidualScale, IsHardlyMovedByOutliers) {
  EXPECT_GT(ResidualScale(MeanOf(0.01, 1000, 0), 0), 0.2);
  EXPECT_LT(IteratedScale(0.01, 1000), 0.0145);
}

// The slope of ψ by differences, against the weights, over Gaussian residuals.
TEST(ResidualScale, WeightsOverrateTheCurvature) {
  const CounterRandom random(3);
  const auto psi = [](double e) { return e / std::pow(1 + e * e / 6.25, 2); };
  double weights = 0, slopes = 0;
  for (int i = 0; i < 20000; ++i) {
    const double e = random.Normal(std::uint64_t(i));
    weights += 1 / std::pow(1 + e * e / 6.25, 2);
    slopes += (psi(e + 1e-4) - psi(e - 1e-4)) / 2e-4;
  }
  EXPECT_NEAR(CurvatureLoss(2.5), weights / slopes, 0.03);
  EXPECT_GT(CurvatureLoss(2.5), 1.2);
  EXPECT_NEAR(CurvatureLoss(1000), 1, 1e-5);
}

}  // namespace
}  // namespace silt::tracker
