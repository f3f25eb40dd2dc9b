// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/absolute_error.h"

#include <Eigen/Dense>
#include <numbers>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

Vec3d Mean(const std::vector<Vec3d>& points) {
  Vec3d sum;
  for (const Vec3d& p : points) sum += p;
  return (1.0 / double(points.size())) * sum;
}

Eigen::Vector3d ToEigen(const Vec3d& v) { return {v.x, v.y, v.z}; }

Mat3d FromEigen(const Eigen::Matrix3d& m) {
  Mat3d result;
  for (int i = 0; i < 3; ++i) result.row[i] = {m(i, 0), m(i, 1), m(i, 2)};
  return result;
}

}  // namespace

// With the centred points' covariance Σ = Σᵢ (toᵢ)(fromᵢ)ᵀ = U·D·Vᵀ the rotation is U·S·Vᵀ, where
// S = diag(1, 1, ±1) keeps it from being a reflection.
SE3d AlignedRigidly(const std::vector<Vec3d>& to, const std::vector<Vec3d>& from) {
  SILT_CHECK(!to.empty() && to.size() == from.size());
  const Vec3d to_mean = Mean(to), from_mean = Mean(from);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < to.size(); ++i) {
    covariance += ToEigen(to[i] - to_mean) * ToEigen(from[i] - from_mean).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d s = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) s(2) = -1;
  const Eigen::Matrix3d rotation = svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose();
  const Quaterniond q = QuaternionFromMatrix(FromEigen(rotation));
  return {q, to_mean - q * from_mean};
}

std::vector<PoseError> PaperErrors(const std::vector<PosePair>& pairs) {
  SILT_CHECK(!pairs.empty());
  const SE3d truth_from_estimate =
      pairs.front().truth.world_from_camera * pairs.front().estimate.world_from_camera.Inverse();
  std::vector<PoseError> errors;
  for (const PosePair& pair : pairs) {
    const SE3d& truth = pair.truth.world_from_camera;
    const SE3d estimate = truth_from_estimate * pair.estimate.world_from_camera;
    errors.push_back(
        {pair.truth.time_s, 100 * Norm(estimate.translation - truth.translation),
         (180 / std::numbers::pi) * (truth.rotation.Conjugate() * estimate.rotation).Log()});
  }
  return errors;
}

PaperStatistics SummarizePaperErrors(const std::vector<PoseError>& errors) {
  std::vector<double> position, x, y, z;
  for (const PoseError& error : errors) {
    position.push_back(error.position_cm);
    x.push_back(error.orientation_deg.x);
    y.push_back(error.orientation_deg.y);
    z.push_back(error.orientation_deg.z);
  }
  return {Summarize(position), {Summarize(x), Summarize(y), Summarize(z)}};
}

Statistics AlignedTrajectoryError(const std::vector<PosePair>& pairs) {
  std::vector<Vec3d> truth, estimate;
  for (const PosePair& pair : pairs) {
    truth.push_back(pair.truth.world_from_camera.translation);
    estimate.push_back(pair.estimate.world_from_camera.translation);
  }
  const SE3d truth_from_estimate = AlignedRigidly(truth, estimate);
  std::vector<double> errors_m;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    errors_m.push_back(Norm(truth[i] - truth_from_estimate * estimate[i]));
  }
  return Summarize(errors_m);
}

}  // namespace silt::experiments
