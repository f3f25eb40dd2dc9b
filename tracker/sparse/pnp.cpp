// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/pnp.h"

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

cv::Matx33d Intrinsics(const PinholeCamera& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

SE3d PoseFrom(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
  return {Quaterniond::Exp({rotation[0], rotation[1], rotation[2]}),
          {translation[0], translation[1], translation[2]}};
}

// ‖p_k − p̂_k‖² in square pixels; infinite behind the camera.
double SquaredError(const PnpProblem& problem, const SE3d& pose, std::size_t k) {
  const Vec3d p = pose * problem.points[k];
  if (!(p.z > 0)) return HUGE_VAL;
  const Vec2d error = problem.camera.Project(p) - problem.pixels[k];
  return error.x * error.x + error.y * error.y;
}

PnpSolution Inliers(const PnpProblem& problem, const SE3d& pose, double reprojection_px) {
  PnpSolution solution{pose, {}, 0};
  double sum = 0;
  for (std::size_t k = 0; k < problem.points.size(); ++k) {
    const double squared = SquaredError(problem, pose, k);
    if (!(squared <= reprojection_px * reprojection_px)) continue;
    solution.inliers.push_back(int(k));
    sum += squared;
  }
  if (!solution.inliers.empty())
    solution.rmse_px = std::sqrt(sum / double(solution.inliers.size()));
  return solution;
}

// Levenberg-Marquardt on the reprojection errors of the inliers, from the solution's pose.
SE3d Refined(const PnpProblem& problem, const PnpSolution& solution) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (int k : solution.inliers) {
    const Vec3d& point = problem.points[std::size_t(k)];
    const Vec2d& pixel = problem.pixels[std::size_t(k)];
    points.emplace_back(point.x, point.y, point.z);
    pixels.emplace_back(pixel.x, pixel.y);
  }
  const Vec3d omega = solution.current_from_keyframe.rotation.Log();
  const Vec3d& t = solution.current_from_keyframe.translation;
  cv::Vec3d rotation{omega.x, omega.y, omega.z}, translation{t.x, t.y, t.z};
  cv::solvePnPRefineLM(points, pixels, Intrinsics(problem.camera), cv::noArray(), rotation,
                       translation);
  return PoseFrom(rotation, translation);
}

std::optional<SE3d> Ransac(const PnpProblem& problem, const PnpOptions& options) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const Vec3d& p : problem.points) points.emplace_back(p.x, p.y, p.z);
  for (const Vec2d& p : problem.pixels) pixels.emplace_back(p.x, p.y);
  cv::Vec3d rotation, translation;
  std::vector<int> inliers;
  // P3P inside: unlike EPnP it has no trouble with points on a plane. OpenCV's RANSAC seeds itself
  // anew in each call.
  const bool found =
      cv::solvePnPRansac(points, pixels, Intrinsics(problem.camera), cv::noArray(), rotation,
                         translation, false, options.max_iterations, float(options.reprojection_px),
                         options.confidence, inliers, cv::SOLVEPNP_P3P);
  if (!found) return {};
  return PoseFrom(rotation, translation);
}

bool IsFinite(const SE3d& pose) {
  const Quaterniond& q = pose.rotation;
  const Vec3d& t = pose.translation;
  return std::isfinite(q.w + q.x + q.y + q.z + t.x + t.y + t.z);
}

}  // namespace

void PnpOptions::Validate() const {
  if (!(reprojection_px > 0)) throw Error("pnp: reprojection_px must be positive");
  if (max_iterations < 1) throw Error("pnp: max_iterations must be at least 1");
  if (!(confidence > 0 && confidence < 1)) throw Error("pnp: confidence must lie between 0 and 1");
  if (min_inliers < 4) throw Error("pnp: min_inliers must be at least 4");
}

std::optional<PnpSolution> SolvePnp(const PnpProblem& problem, const PnpOptions& options) {
  options.Validate();
  SILT_CHECK(problem.points.size() == problem.pixels.size());
  const auto least = std::size_t(options.min_inliers);
  if (problem.points.size() < least) return {};
  const std::optional<SE3d> start = Ransac(problem, options);
  if (!start || !IsFinite(*start)) return {};
  PnpSolution solution = Inliers(problem, *start, options.reprojection_px);
  // The refined pose may gain inliers, from which a second refinement gains again.
  for (int round = 0; round < 2; ++round) {
    if (solution.inliers.size() < least) return {};
    const SE3d refined = Refined(problem, solution);
    if (!IsFinite(refined)) return {};
    solution = Inliers(problem, refined, options.reprojection_px);
  }
  if (solution.inliers.size() < least) return {};
  return solution;
}

}  // namespace silt::tracker
