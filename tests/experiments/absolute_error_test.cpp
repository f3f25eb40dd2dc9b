// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/absolute_error.h"

#include <gtest/gtest.h>

#include <numbers>

#include "silt/core/random.h"

namespace silt::experiments {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

const SE3d kSomewhere = SE3d::Exp({{0.3, -2.1, 0.7}, {5, -3, 1}});

std::vector<Vec3d> RandomPoints(int n, std::uint64_t stream) {
  const CounterRandom random(11, stream);
  std::vector<Vec3d> points;
  for (std::uint64_t i = 0; i < std::uint64_t(n); ++i) {
    points.push_back({random.Normal(3 * i), random.Normal(3 * i + 1), random.Normal(3 * i + 2)});
  }
  return points;
}

double SumOfSquares(const SE3d& motion, const std::vector<Vec3d>& to,
                    const std::vector<Vec3d>& from) {
  double sum = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Vec3d d = to[i] - motion * from[i];
    sum += Dot(d, d);
  }
  return sum;
}

TEST(AlignedRigidly, RecoversAMotion) {
  const std::vector<Vec3d> from = RandomPoints(10, 0);
  std::vector<Vec3d> to;
  for (const Vec3d& p : from) to.push_back(kSomewhere * p);
  EXPECT_LT(SumOfSquares(AlignedRigidly(to, from), to, from), 1e-24);
}

TEST(AlignedRigidly, NoSmallMotionImprovesTheResult) {
  const std::vector<Vec3d> to = RandomPoints(30, 1), from = RandomPoints(30, 2);
  const SE3d best = AlignedRigidly(to, from);
  const double least = SumOfSquares(best, to, from);
  for (int axis = 0; axis < 6; ++axis) {
    for (const double step : {-1e-3, 1e-3}) {
      double xi[6] = {};
      xi[axis] = step;
      const SE3d moved = SE3d::Exp({{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}}) * best;
      EXPECT_GT(SumOfSquares(moved, to, from), least);
    }
  }
}

TEST(AlignedRigidly, NeverMirrors) {
  const std::vector<Vec3d> from = RandomPoints(10, 3);
  std::vector<Vec3d> to;
  for (const Vec3d& p : from) to.push_back({-p.x, p.y, p.z});
  const SE3d motion = AlignedRigidly(to, from);
  const Mat3d r = motion.rotation.Matrix();
  EXPECT_NEAR(Dot(Cross(r.row[0], r.row[1]), r.row[2]), 1, 1e-12);
  EXPECT_GT(SumOfSquares(motion, to, from), 1);
}

TEST(AlignedRigidly, OfPointsOnALineAndOfOnePointIsFinite) {
  const std::vector<Vec3d> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_LT(SumOfSquares(AlignedRigidly(line, line), line, line), 1e-24);
  EXPECT_LT(Norm(AlignedRigidly({{1, 2, 3}}, {{4, 5, 6}}) * Vec3d{4, 5, 6} - Vec3d{1, 2, 3}),
            1e-12);
}

// A truth that moves, and an estimate of it in a world of its own whose second pose is wrong by
// (3, 4, 0) cm in the true world and third by a turn of 2° about the camera's y.
std::vector<PosePair> PairsWithKnownErrors() {
  std::vector<PosePair> pairs;
  for (int i = 0; i < 3; ++i) {
    const SE3d truth = SE3d::Exp({{0.1 * i, 0.2, 0}, {0.5 * i, 1, 2}});
    SE3d estimate = truth;
    if (i == 1) estimate.translation += {0.03, 0.04, 0};
    if (i == 2) estimate = truth * SE3d::Exp({{0, 2 * kDegree, 0}, {}});
    pairs.push_back({{0.1 * i, truth}, {0.1 * i, kSomewhere * estimate}});
  }
  return pairs;
}

TEST(PaperErrors, AreMeasuredFromTheFirstPose) {
  const std::vector<PoseError> errors = PaperErrors(PairsWithKnownErrors());
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_NEAR(errors[0].position_cm, 0, 1e-12);
  EXPECT_NEAR(errors[1].position_cm, 5, 1e-10);
  EXPECT_NEAR(Norm(errors[1].orientation_deg), 0, 1e-10);
  EXPECT_NEAR(errors[2].position_cm, 0, 1e-10);
  EXPECT_NEAR(Norm(errors[2].orientation_deg - Vec3d{0, 2, 0}), 0, 1e-10);
}

TEST(PaperErrors, AWrongFirstPoseShowsInAllOthers) {
  std::vector<PosePair> pairs = PairsWithKnownErrors();
  SE3d& first = pairs[0].estimate.world_from_camera;
  first = first * SE3d::Exp({{}, {0.1, 0, 0}});
  const std::vector<PoseError> errors = PaperErrors(pairs);
  EXPECT_NEAR(errors[0].position_cm, 0, 1e-12);
  EXPECT_NEAR(errors[2].position_cm, 10, 1e-9);
}

TEST(PaperErrors, AreSummarizedPerAxisWithTheirSign) {
  const PaperStatistics s = SummarizePaperErrors({{0, 1, {1, -2, 3}}, {1, 3, {3, -4, -3}}});
  EXPECT_DOUBLE_EQ(s.position_cm.mean, 2);
  EXPECT_DOUBLE_EQ(s.orientation_deg[0].mean, 2);
  EXPECT_DOUBLE_EQ(s.orientation_deg[1].max, -2);
  EXPECT_DOUBLE_EQ(s.orientation_deg[1].min, -4);
  EXPECT_DOUBLE_EQ(s.orientation_deg[2].mean, 0);
  EXPECT_DOUBLE_EQ(s.orientation_deg[2].rmse, 3);
}

TEST(AlignedTrajectoryError, IsBlindToTheChoiceOfWorldAndNotToErrors) {
  std::vector<PosePair> pairs;
  // Square of 2 m; the estimate is stretched by 1 cm outwards along its x: ±1 cm at each corner.
  const Vec3d corners[] = {{1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  for (const Vec3d& c : corners) {
    const SE3d truth{{}, c};
    const SE3d estimate = kSomewhere * SE3d{{}, {1.01 * c.x, c.y, c.z}};
    pairs.push_back({{0, truth}, {0, estimate}});
  }
  const Statistics s = AlignedTrajectoryError(pairs);
  EXPECT_NEAR(s.rmse, 0.01, 1e-12);
  EXPECT_NEAR(s.max, 0.01, 1e-12);
}

}  // namespace
}  // namespace silt::experiments
