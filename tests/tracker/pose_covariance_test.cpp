// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/pose_covariance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::tracker {
namespace {

const SE3d kPose{Quaterniond::Exp({0.3, -0.5, 0.8}), {0.7, -1.1, 2.3}};

Covariance6 Diagonal(const double (&variances)[6]) {
  Covariance6 covariance{};
  for (int i = 0; i < 6; ++i) covariance[7 * i] = variances[i];
  return covariance;
}

// ξ·ξᵀ.
Covariance6 Outer(const Twistd& xi) {
  const double v[6] = {xi.omega.x, xi.omega.y, xi.omega.z, xi.v.x, xi.v.y, xi.v.z};
  Covariance6 outer;
  for (int i = 0; i < 36; ++i) outer[i] = v[i / 6] * v[i % 6];
  return outer;
}

TEST(PoseCovariance, MovesWithTheErrorItIsOf) {
  const Twistd xi{{0.01, 0.02, -0.03}, {0.05, -0.01, 0.02}};
  // T·exp(ξ)·T⁻¹ = exp(ξ'), whose ξ' the covariance of ξ·ξᵀ has to know.
  const Twistd moved = (kPose * SE3d::Exp(xi) * kPose.Inverse()).Log();
  const Covariance6 expected = Outer(moved), covariance = InFrame(Outer(xi), kPose);
  for (int i = 0; i < 36; ++i) EXPECT_NEAR(covariance[i], expected[i], 1e-12) << i;
}

TEST(PoseCovariance, ThereAndBackIsTheSame) {
  const Covariance6 covariance = Diagonal({1, 2, 3, 4, 5, 6});
  const Covariance6 back = InFrame(InFrame(covariance, kPose), kPose.Inverse());
  for (int i = 0; i < 36; ++i) EXPECT_NEAR(back[i], covariance[i], 1e-11) << i;
}

TEST(PoseCovariance, ErrorsAreSquaredInItsUnits) {
  const Covariance6 covariance = Diagonal({0.01, 0.04, 0.01, 1, 4, 9});
  EXPECT_NEAR(*NormalizedSquare({{0.1, 0.2, 0}, {0, 2, 0}}, covariance), 3, 1e-12);
  EXPECT_NEAR(*NormalizedSquare({{0, 0, 0}, {0, 0, 6}}, Sum(covariance, covariance)), 2, 1e-12);
}

TEST(PoseCovariance, WithoutAnInverseThereIsNoSquare) {
  EXPECT_FALSE(NormalizedSquare({{0.1, 0, 0}, {}}, Covariance6{}));
  EXPECT_FALSE(NormalizedSquare({{NAN, 0, 0}, {}}, Diagonal({1, 1, 1, 1, 1, 1})));
}

TEST(PoseCovariance, TheLargestDeviationSeesMetresFromADistance) {
  EXPECT_NEAR(LargestDeviation(Diagonal({0.01, 0.04, 0.01, 0, 0, 0}), 0.5), 0.2, 1e-12);
  EXPECT_NEAR(LargestDeviation(Diagonal({0.01, 0.04, 0.01, 0, 1, 0}), 0.5), 0.5, 1e-12);
  EXPECT_EQ(LargestDeviation(Diagonal({NAN, 0, 0, 0, 0, 0}), 1), HUGE_VAL);
}

}  // namespace
}  // namespace silt::tracker
