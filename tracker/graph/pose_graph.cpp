// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/pose_graph.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <array>
#include <string>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Delta = std::array<double, 6>;

// √ of χ²₆'s quantile at 0.99: what one in a hundred right edges errs by.
constexpr double kLargeError = 4.1;

ceres::Solver::Options SolverOptions() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = 30;
  options.function_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  return options;
}

void CheckIndices(const PoseEdge& edge, std::size_t poses) {
  for (const int index : {edge.from, edge.to}) {
    if (index >= 0 && std::size_t(index) < poses) continue;
    throw Error("pose graph: an edge from " + std::to_string(edge.from) + " to " +
                std::to_string(edge.to) + " names none of the " + std::to_string(poses) + " poses");
  }
}

}  // namespace

std::optional<EdgeError> ErrorOf(const PoseEdge& edge, const std::vector<SE3d>& world_from_pose) {
  const Eigen::LLT<Matrix6> llt(Eigen::Map<const Matrix6>(edge.covariance.data()));
  if (llt.info() != Eigen::Success) return std::nullopt;
  const Matrix6 whitening = llt.matrixL().solve(Matrix6::Identity());
  if (!whitening.allFinite()) return std::nullopt;
  EdgeError error{edge.to_from_from, world_from_pose[edge.from], world_from_pose[edge.to], {}};
  Eigen::Map<Matrix6>(error.whitening.data()) = whitening;
  return error;
}

GraphCost OptimizePoses(const std::vector<PoseEdge>& edges, std::vector<SE3d>* world_from_pose) {
  std::vector<Delta> deltas(world_from_pose->size(), Delta{});
  ceres::LossFunctionWrapper loss(new ceres::HuberLoss(kLargeError), ceres::TAKE_OWNERSHIP);
  ceres::Problem::Options problem_options;
  problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problem_options);
  for (const PoseEdge& edge : edges) {
    CheckIndices(edge, deltas.size());
    const std::optional<EdgeError> error = ErrorOf(edge, *world_from_pose);
    if (!error || edge.from == edge.to) continue;
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<EdgeError, 6, 6, 6>(new EdgeError(*error)), &loss,
        deltas[edge.from].data(), deltas[edge.to].data());
  }
  if (problem.NumResidualBlocks() == 0) return {};
  if (problem.HasParameterBlock(deltas[0].data())) {
    problem.SetParameterBlockConstant(deltas[0].data());
  }
  GraphCost cost;
  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(), &problem, &summary);
  cost.before = summary.initial_cost;
  loss.Reset(new ceres::CauchyLoss(kLargeError), ceres::TAKE_OWNERSHIP);
  ceres::Solve(SolverOptions(), &problem, &summary);
  if (!summary.IsSolutionUsable()) return {cost.before, cost.before};
  loss.Reset(new ceres::HuberLoss(kLargeError), ceres::TAKE_OWNERSHIP);
  problem.Evaluate({}, &cost.after, nullptr, nullptr, nullptr);
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    (*world_from_pose)[i] = EdgeError::Moved((*world_from_pose)[i], deltas[i].data());
  }
  return cost;
}

}  // namespace silt::tracker
