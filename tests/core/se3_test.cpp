// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/se3.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include "silt/core/random.h"

namespace silt {
namespace {

Twistd RandomTwist(std::uint64_t i, double angle) {
  const CounterRandom random(7, i);
  const Vec3d axis = Normalized(Vec3d{random.Normal(0), random.Normal(1), random.Normal(2)});
  return {angle * axis, {random.Normal(3), random.Normal(4), random.Normal(5)}};
}

Eigen::Matrix4d Matrix(const SE3d& motion) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const Mat3d r = motion.rotation.Matrix();
  for (int i = 0; i < 3; ++i) m.block<1, 3>(i, 0) << r.row[i].x, r.row[i].y, r.row[i].z;
  m.block<3, 1>(0, 3) << motion.translation.x, motion.translation.y, motion.translation.z;
  return m;
}

// [ξ]ₓ of the paper's eq. 5.
Eigen::Matrix4d Hat(const Twistd& xi) {
  Eigen::Matrix4d m;
  m << 0, -xi.omega.z, xi.omega.y, xi.v.x,  //
      xi.omega.z, 0, -xi.omega.x, xi.v.y,   //
      -xi.omega.y, xi.omega.x, 0, xi.v.z,   //
      0, 0, 0, 0;
  return m;
}

class SE3AtAngle : public testing::TestWithParam<double> {};

TEST_P(SE3AtAngle, ExpIsTheMatrixExponential) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Twistd xi = RandomTwist(i, GetParam());
    EXPECT_LT((Matrix(SE3d::Exp(xi)) - Hat(xi).exp()).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST_P(SE3AtAngle, LogInvertsExp) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Twistd xi = RandomTwist(i, GetParam());
    const Twistd back = SE3d::Exp(xi).Log();
    EXPECT_LT(Norm(back.omega - xi.omega), 1e-13);
    EXPECT_LT(Norm(back.v - xi.v), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, SE3AtAngle,
                         testing::Values(0.0, 1e-9, 1e-4, 0.019, 0.021, 0.49, 0.51, 0.99, 1.01,
                                         1.99, 2.01, 3.1));

TEST(SE3, CompositionAndInverseAreThoseOfTheMatrices) {
  const SE3d a = SE3d::Exp(RandomTwist(1, 0.7)), b = SE3d::Exp(RandomTwist(2, 2.0));
  EXPECT_LT((Matrix(a * b) - Matrix(a) * Matrix(b)).norm(), 1e-14);
  EXPECT_LT((Matrix(a.Inverse()) * Matrix(a) - Eigen::Matrix4d::Identity()).norm(), 1e-14);
  const Vec3d p{1, -2, 3};
  const Eigen::Vector4d q = Matrix(a) * Eigen::Vector4d(p.x, p.y, p.z, 1);
  EXPECT_LT(Norm(a * p - Vec3d{q(0), q(1), q(2)}), 1e-14);
}

TEST(SE3, QuaternionFromMatrixInvertsMatrixForEveryPivot) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Quaterniond q = Quaterniond::Exp(RandomTwist(i, 0.03 * double(i % 100)).omega);
    const Quaterniond back = QuaternionFromMatrix(q.Matrix());
    EXPECT_LT(Norm((q.Conjugate() * back).Log()), 1e-12);
  }
}

}  // namespace
}  // namespace silt
