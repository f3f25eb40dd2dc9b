// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/graph/pose_graph.h"

#include <ceres/ceres.h>
#include <ceres/gradient_checker.h>
#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt::tracker {
namespace {

Covariance6 Diagonal(double rad, double m) {
  Covariance6 covariance{};
  for (int i = 0; i < 6; ++i) covariance[7 * i] = i < 3 ? rad * rad : m * m;
  return covariance;
}

double Distance(const SE3d& a, const SE3d& b) { return Norm(a.translation - b.translation); }

// A camera that goes around a table, 1 m from its middle, `count` poses to the whole round.
std::vector<SE3d> Round(int count) {
  std::vector<SE3d> poses;
  for (int i = 0; i < count; ++i) {
    const Quaterniond turn = Quaterniond::Exp({0, 2 * M_PI * i / count, 0});
    poses.push_back({turn, turn * Vec3d{0, 0, -1}});
  }
  return poses;
}

PoseEdge TrueEdge(const std::vector<SE3d>& poses, int from, int to) {
  return {from, to, poses[to].Inverse() * poses[from], Diagonal(1e-3, 1e-3)};
}

// Ceres' finite differences against the derivatives that it is given, scaled by `corruption`.
bool JacobiansAgree(double corruption) {
  struct Corrupted : ceres::SizedCostFunction<6, 6, 6> {
    bool Evaluate(double const* const* p, double* r, double** j) const override {
      if (!own->Evaluate(p, r, j)) return false;
      if (j && j[1]) j[1][8] *= factor;
      return true;
    }
    std::unique_ptr<ceres::CostFunction> own;
    double factor = 1;
  };
  const std::vector<SE3d> poses{SE3d::Exp({{0.3, -0.2, 0.5}, {1, 2, -1}}),
                                SE3d::Exp({{-0.4, 0.6, 0.1}, {0.5, 1, 0}})};
  PoseEdge edge = TrueEdge(poses, 0, 1);
  edge.to_from_from = SE3d::Exp({{0.05, 0.02, -0.04}, {0.1, -0.05, 0.02}}) * edge.to_from_from;
  edge.covariance = Diagonal(0.2, 0.5);
  edge.covariance[1] = edge.covariance[6] = 0.01;
  Corrupted function;
  function.own = std::make_unique<ceres::AutoDiffCostFunction<EdgeError, 6, 6, 6>>(
      new EdgeError(*ErrorOf(edge, poses)));
  function.factor = corruption;
  const double from[6] = {0.02, -0.01, 0.03, 0.1, 0, -0.2}, to[6] = {0, 0.04, 0.01, -0.1, 0.3, 0};
  const double* parameters[] = {from, to};
  const std::vector<const ceres::Manifold*> none(2, nullptr);
  ceres::NumericDiffOptions numeric;
  numeric.relative_step_size = 1e-5;
  ceres::GradientChecker checker(&function, &none, numeric);
  return checker.Probe(parameters, 1e-6, nullptr);
}

TEST(EdgeError, CeresConfirmsItsJacobians) { EXPECT_TRUE(JacobiansAgree(1)); }
TEST(EdgeError, CeresFindsACorruptedJacobian) { EXPECT_FALSE(JacobiansAgree(1.001)); }

// e is ξ in units of its deviations.
TEST(EdgeError, IsTheNormalizedErrorOfTheMeasurement) {
  const std::vector<SE3d> poses = Round(5);
  PoseEdge edge = TrueEdge(poses, 1, 2);
  edge.covariance = Diagonal(0.01, 0.2);
  edge.to_from_from = SE3d::Exp({{0.02, 0, 0}, {0, -0.2, 0}}) * edge.to_from_from;
  const double zero[6] = {};
  double e[6];
  ErrorOf(edge, poses)->operator()(zero, zero, e);
  const double expected[6] = {2, 0, 0, 0, -1, 0};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(e[i], expected[i], 1e-9) << i;
}

TEST(PoseGraph, FindsThePosesThatEdgesTell) {
  const std::vector<SE3d> truth = Round(8);
  std::vector<PoseEdge> edges;
  for (int i = 0; i < 8; ++i) edges.push_back(TrueEdge(truth, i, (i + 1) % 8));
  const CounterRandom random(3);
  std::vector<SE3d> poses = truth;
  for (int i = 1; i < 8; ++i) {
    const auto n = [&](int k) { return 0.05 * random.Normal(std::uint64_t(6 * i + k)); };
    poses[i] = poses[i] * SE3d::Exp({{n(0), n(1), n(2)}, {n(3), n(4), n(5)}});
  }
  const GraphCost cost = OptimizePoses(edges, &poses);
  EXPECT_GT(cost.before, 100);
  EXPECT_LT(cost.after, 1e-6);
  for (int i = 0; i < 8; ++i) EXPECT_LT(Distance(poses[i], truth[i]), 1e-6) << i;
  EXPECT_EQ(Distance(poses[0], truth[0]), 0);
}

// Each step errs the same way, by 2 mm and 2 mrad, and only the last edge knows where the first
// pose was.
std::vector<SE3d> DriftedRound(const PoseEdge& closing, GraphCost* cost) {
  const std::vector<SE3d> truth = Round(24);
  const SE3d drift = SE3d::Exp({{0, 2e-3, 0}, {2e-3, 0, 0}});
  std::vector<PoseEdge> edges;
  std::vector<SE3d> poses{truth[0]};
  for (int i = 1; i < 24; ++i) {
    edges.push_back(TrueEdge(truth, i - 1, i));
    edges.back().to_from_from = drift * edges.back().to_from_from;
    poses.push_back(poses.back() * edges.back().to_from_from.Inverse());
  }
  edges.push_back(closing);
  *cost = OptimizePoses(edges, &poses);
  return poses;
}

double Worst(const std::vector<SE3d>& poses) {
  const std::vector<SE3d> truth = Round(24);
  double worst = 0;
  for (int i = 0; i < 24; ++i) worst = std::max(worst, Distance(poses[i], truth[i]));
  return worst;
}

TEST(PoseGraph, ALoopUndoesTheDrift) {
  GraphCost cost;
  const PoseEdge no_loop = TrueEdge(Round(24), 0, 0);
  const double open = Worst(DriftedRound(no_loop, &cost));
  const double closed = Worst(DriftedRound(TrueEdge(Round(24), 23, 0), &cost));
  EXPECT_GT(open, 0.05);
  EXPECT_LT(closed, open / 3);
  EXPECT_GT(cost.before, 3 * cost.after);
}

TEST(PoseGraph, AWrongLoopBendsLittle) {
  GraphCost cost;
  std::vector<SE3d> truth = Round(24);
  PoseEdge wrong = TrueEdge(truth, 12, 0);
  wrong.to_from_from = SE3d::Exp({{}, {0.8, 0, 0}}) * wrong.to_from_from;
  const double open = Worst(DriftedRound(TrueEdge(truth, 0, 0), &cost));
  EXPECT_LT(Worst(DriftedRound(wrong, &cost)), open + 0.1);
}

TEST(PoseGraph, LeavesOutWhatTellsNothing) {
  const std::vector<SE3d> truth = Round(4);
  std::vector<SE3d> poses = truth;
  PoseEdge sure = TrueEdge(truth, 0, 2);
  sure.covariance = {};
  const GraphCost cost = OptimizePoses({sure}, &poses);
  EXPECT_EQ(cost.after, 0);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Distance(poses[i], truth[i]), 0);
  EXPECT_THROW(OptimizePoses({{0, 4, {}, Diagonal(1, 1)}}, &poses), Error);
  EXPECT_THROW(OptimizePoses({{-1, 2, {}, Diagonal(1, 1)}}, &poses), Error);
}

}  // namespace
}  // namespace silt::tracker
