// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

// k/fps and start_s may differ by rounding where they mean the same instant.
constexpr double kFrameTolerance = 1e-6;
constexpr double kMostSamples = 1e6;
constexpr double kDegrees = 180 / std::numbers::pi;

Vec3d Lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

}  // namespace

std::vector<double> FrameTimes(double fps, double start_s, double duration_s) {
  const auto bounded = [](double x) { return x > 0 && x <= 1e6; };
  if (!bounded(fps)) throw Error("the frame rate must be positive (fps)");
  if (!(start_s == 0 || bounded(start_s))) throw Error("the start must be 0 s or later");
  if (!bounded(duration_s)) throw Error("the duration must be positive (seconds)");
  const auto first = std::int64_t(std::ceil(start_s * fps - kFrameTolerance));
  const auto end = std::int64_t(std::ceil((start_s + duration_s) * fps - kFrameTolerance));
  if (end - first > 10'000'000) throw Error("more than ten million frames (fps, duration)");
  std::vector<double> times;
  for (std::int64_t k = first; k < end; ++k) times.push_back(double(k) / fps);
  return times;
}

CameraPath::CameraPath(PoseSpline spline, HandShake shake, std::optional<FitResiduals> fit)
    : spline_(std::move(spline)), shake_(std::move(shake)), fit_(fit) {
  SILT_CHECK(spline_.start_s() == 0);
}

PathStatistics CameraPath::Statistics() const {
  const int steps = std::max(1, int(std::lround(std::min(duration_s() * 1000, kMostSamples))));
  const double step_s = duration_s() / steps;
  SE3d last = At(0.0);
  PathStatistics s;
  s.duration_s = duration_s();
  s.lowest = s.highest = last.translation;
  for (int k = 1; k <= steps; ++k) {
    const SE3d pose = At(k * step_s);
    const double moved_m = Norm(pose.translation - last.translation);
    const double turned_deg = kDegrees * RotationAngle(last.rotation.Conjugate() * pose.rotation);
    s.length_m += moved_m;
    s.mean_turn_deg_s += turned_deg / duration_s();
    s.max_speed_m_s = std::max(s.max_speed_m_s, moved_m / step_s);
    s.max_turn_deg_s = std::max(s.max_turn_deg_s, turned_deg / step_s);
    s.lowest = Lower(s.lowest, pose.translation);
    s.highest = -Lower(-s.highest, -pose.translation);
    last = pose;
  }
  s.mean_speed_m_s = s.length_m / duration_s();
  AddAccelerations(s);
  return s;
}

void CameraPath::AddAccelerations(PathStatistics& s) const {
  const int steps = std::max(1, int(std::lround(std::min(duration_s() * 200, kMostSamples))));
  for (int k = 0; k <= steps; ++k) {
    const CameraMotion motion = Motion(k * (duration_s() / steps));
    const double m_s2 = Norm(motion.acceleration);
    const double deg_s2 = kDegrees * Norm(motion.angular_acceleration);
    s.mean_acceleration_m_s2 += m_s2 / (steps + 1);
    s.max_acceleration_m_s2 = std::max(s.max_acceleration_m_s2, m_s2);
    s.max_turn_acceleration_deg_s2 = std::max(s.max_turn_acceleration_deg_s2, deg_s2);
  }
}

Trajectory CameraPath::Sample(double fps, double start_s, double duration_s) const {
  if (start_s + duration_s > this->duration_s() + kFrameTolerance) {
    throw Error("the stretch from " + std::to_string(start_s) + " to " +
                std::to_string(start_s + duration_s) + " s leaves the camera path, which lasts " +
                std::to_string(this->duration_s()) + " s");
  }
  Trajectory trajectory;
  for (const double time_s : FrameTimes(fps, start_s, duration_s)) {
    trajectory.push_back({time_s, At(time_s)});
  }
  return trajectory;
}

}  // namespace silt::sim
