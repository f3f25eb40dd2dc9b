// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/levenberg_marquardt.h"

#include <gtest/gtest.h>

namespace silt::tracker {
namespace {

const SE3d kBest = SE3d::Exp({{0.1, -0.2, 0.05}, {0.3, 0.1, -0.2}});

// ½|d|² of the twist d to the best pose, with a curvature that is told too small, so that undamped
// steps overshoot and are rejected.
NormalEquations EquationsAt(const SE3d& pose, bool with_matrix) {
  const Twistd d = (pose * kBest.Inverse()).Log();
  const double values[6] = {d.omega.x, d.omega.y, d.omega.z, d.v.x, d.v.y, d.v.z};
  NormalEquations equations;
  equations.cost.pixels = 100;
  for (const double value : values) equations.cost.sum += 0.5 * value * value;
  if (!with_matrix) return equations;
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) {
    equations.hessian[std::size_t(k)] = 0.3;
    equations.gradient[std::size_t(i)] = values[i];
  }
  return equations;
}

AlignmentPlan TwoLevels(bool linearize_trials) {
  AlignmentPlan plan;
  plan.levels = 2;
  plan.initial_damping = 1e-3;
  plan.damping_factor = 10;
  plan.linearize_trials = linearize_trials;
  for (int i = 0; i < 2; ++i) {
    plan.max_iterations[i] = 9 - 2 * i;
    plan.measured_pixels[i] = 100;
  }
  return plan;
}

struct Descent {
  LevenbergMarquardt optimizer;
  int costs = 0, equations = 0;
};

Descent RunToTheEnd(const AlignmentPlan& plan) {
  Descent run{LevenbergMarquardt(plan, {})};
  LevenbergMarquardt& optimizer = run.optimizer;
  while (optimizer.wanted() != LevenbergMarquardt::Wanted::kNothing) {
    const bool with_matrix = optimizer.wanted() == LevenbergMarquardt::Wanted::kEquations;
    ++(with_matrix ? run.equations : run.costs);
    optimizer.Take(plan, EquationsAt(optimizer.pose(), with_matrix));
  }
  return run;
}

TEST(LevenbergMarquardt, LinearizingTrialsAtOnceSavesRoundsAndChangesNothing) {
  const Descent apart = RunToTheEnd(TwoLevels(false)), at_once = RunToTheEnd(TwoLevels(true));
  const SE3d &a = apart.optimizer.accepted_pose(), &b = at_once.optimizer.accepted_pose();
  EXPECT_EQ(a.rotation.w, b.rotation.w);
  EXPECT_EQ(a.rotation.x, b.rotation.x);
  EXPECT_EQ(a.translation.x, b.translation.x);
  EXPECT_EQ(a.translation.y, b.translation.y);
  EXPECT_EQ(apart.optimizer.equations(), at_once.optimizer.equations());
  EXPECT_EQ(apart.optimizer.steps(), at_once.optimizer.steps());
  ASSERT_EQ(apart.optimizer.level_count(), 2);
  ASSERT_EQ(at_once.optimizer.level_count(), 2);
  EXPECT_EQ(apart.optimizer.failure(), AlignmentFailure::kNone);
  EXPECT_EQ(apart.costs, 16) << "a trial for each solve";
  EXPECT_EQ(at_once.costs, 2) << "the last trial of each level";
  EXPECT_LT(at_once.equations + at_once.costs, apart.equations + apart.costs);
  EXPECT_LT(apart.equations, 2 + 14) << "no step is ever rejected";
}

}  // namespace
}  // namespace silt::tracker
