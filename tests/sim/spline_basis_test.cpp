// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/spline_basis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace silt::sim {
namespace {

constexpr double kKnots[6] = {-1.3, -0.2, 0, 0.7, 1.0, 2.9};

// De Boor's recursion: the B-spline of the given degree over knots[i] … knots[i + degree + 1].
double BSpline(const std::vector<double>& knots, int i, int degree, double t) {
  if (degree == 0) return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
  const auto ramp = [&](int j) { return (t - knots[j]) / (knots[j + degree] - knots[j]); };
  return ramp(i) * BSpline(knots, i, degree - 1, t) +
         (1 - ramp(i + 1)) * BSpline(knots, i + 1, degree - 1, t);
}

TEST(CumulativeBasis, IsTheSumOfDeBoorsBSplines) {
  // The first and last B-spline at work on [t₂, t₃] reach one knot farther; where does not matter.
  std::vector<double> knots{-5};
  knots.insert(knots.end(), kKnots, kKnots + 6);
  knots.push_back(7);
  const CumulativeBasis basis = MakeCumulativeBasis(kKnots);
  for (const double u : {0.0, 0.2, 0.5, 0.99}) {
    double sum = 0;
    for (int j = 3; j >= 1; --j) {
      sum += BSpline(knots, j, 3, 0.7 * u);
      EXPECT_NEAR(basis.Lambda(j, u), sum, 1e-14);
    }
  }
}

TEST(CumulativeBasis, OfEvenKnots) {
  const double even[6] = {0, 1, 2, 3, 4, 5};
  const CumulativeBasis basis = MakeCumulativeBasis(even);
  EXPECT_NEAR(basis.Lambda(1, 0.0), 5.0 / 6, 1e-15);
  EXPECT_NEAR(basis.Lambda(2, 0.0), 1.0 / 6, 1e-15);
  EXPECT_EQ(basis.Lambda(3, 0.0), 0);
  EXPECT_NEAR(basis.Lambda(1, 1.0), 1, 1e-15);
}

TEST(MirroredKnots, ReflectTheTimesAtBothEnds) {
  const auto knots = [](const std::vector<double>& times) {
    Trajectory keys;
    for (const double t : times) keys.push_back({t, {}});
    return MirroredKnots(keys);
  };
  EXPECT_THAT(knots({0, 1, 4, 9}), testing::ElementsAre(-4, -1, 0, 1, 4, 9, 14, 17));
  EXPECT_THAT(knots({0, 1, 4}), testing::ElementsAre(-4, -1, 0, 1, 4, 7, 8));
  EXPECT_THAT(knots({2, 3}), testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

}  // namespace
}  // namespace silt::sim
