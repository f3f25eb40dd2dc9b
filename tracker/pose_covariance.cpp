// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/pose_covariance.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace silt::tracker {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Matrix6 ToMatrix(const Covariance6& covariance) {
  return Eigen::Map<const Matrix6>(covariance.data());
}

Covariance6 FromMatrix(const Matrix6& matrix) {
  Covariance6 covariance;
  Eigen::Map<Matrix6>(covariance.data()) = 0.5 * (matrix + matrix.transpose());
  return covariance;
}

Eigen::Matrix3d ToMatrix(const Mat3d& m) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) matrix.row(i) << m.row[i].x, m.row[i].y, m.row[i].z;
  return matrix;
}

Matrix6 Adjoint(const SE3d& pose) {
  const Eigen::Matrix3d r = ToMatrix(pose.rotation.Matrix());
  const Vec3d& t = pose.translation;
  Eigen::Matrix3d cross;
  cross << 0, -t.z, t.y, t.z, 0, -t.x, -t.y, t.x, 0;
  Matrix6 adjoint = Matrix6::Zero();
  adjoint.topLeftCorner<3, 3>() = adjoint.bottomRightCorner<3, 3>() = r;
  adjoint.bottomLeftCorner<3, 3>() = cross * r;
  return adjoint;
}

}  // namespace

Covariance6 InFrame(const Covariance6& covariance, const SE3d& target_from_source) {
  const Matrix6 adjoint = Adjoint(target_from_source);
  return FromMatrix(adjoint * ToMatrix(covariance) * adjoint.transpose());
}

Covariance6 Sum(const Covariance6& a, const Covariance6& b) {
  return FromMatrix(ToMatrix(a) + ToMatrix(b));
}

std::optional<double> NormalizedSquare(const Twistd& error, const Covariance6& covariance) {
  Vector6 xi;
  xi << error.omega.x, error.omega.y, error.omega.z, error.v.x, error.v.y, error.v.z;
  const Eigen::LLT<Matrix6> llt(ToMatrix(covariance));
  if (llt.info() != Eigen::Success) return std::nullopt;
  const double square = xi.dot(llt.solve(xi));
  if (!std::isfinite(square)) return std::nullopt;
  return square;
}

double LargestDeviation(const Covariance6& covariance, double per_metre) {
  Vector6 scale;
  scale << 1, 1, 1, per_metre, per_metre, per_metre;
  const Matrix6 scaled = scale.asDiagonal() * ToMatrix(covariance) * scale.asDiagonal();
  if (!scaled.allFinite()) return HUGE_VAL;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(scaled,
                                                                          Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

}  // namespace silt::tracker
