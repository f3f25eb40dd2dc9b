// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/relative_error.h"

#include <cmath>
#include <numbers>

namespace silt::experiments {
namespace {

// What each pose has covered since the first, in the window's unit.
std::vector<double> Covered(const Trajectory& trajectory, WindowUnit unit) {
  std::vector<double> covered;
  double path_m = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i > 0) {
      path_m += Norm(trajectory[i].world_from_camera.translation -
                     trajectory[i - 1].world_from_camera.translation);
    }
    covered.push_back(unit == WindowUnit::kFrames    ? double(i)
                      : unit == WindowUnit::kSeconds ? trajectory[i].time_s
                                                     : path_m);
  }
  return covered;
}

// The first and last pose of a window.
struct WindowPoses {
  PosePair first, last;
};

// Windows that follow one another. evo starts the first one in metres only after the first window's
// length, which is kept so that its figures come out.
std::vector<WindowPoses> ConsecutiveWindows(const std::vector<PosePair>& pairs,
                                            const Window& window) {
  Trajectory estimate;
  for (const PosePair& pair : pairs) estimate.push_back(pair.estimate);
  const std::vector<double> covered = Covered(estimate, window.unit);
  // Times such as 1/60 s do not add up exactly to a second.
  const double slack = window.unit == WindowUnit::kSeconds ? 1e-6 : 0;
  std::vector<std::size_t> ends;
  std::size_t last = 0;
  if (window.unit != WindowUnit::kMetres && !pairs.empty()) ends.push_back(0);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    if (covered[i] - covered[last] < window.length - slack) continue;
    ends.push_back(i);
    last = i;
  }
  std::vector<WindowPoses> windows;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    windows.push_back({pairs[ends[k - 1]], pairs[ends[k]]});
  }
  return windows;
}

double MedianInterval(const std::vector<double>& times_s) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    intervals_s.push_back(times_s[i] - times_s[i - 1]);
  }
  return intervals_s.empty() ? 0 : Median(intervals_s);
}

// A window from every pose of the estimate whose end is not the last pose.
std::vector<WindowPoses> OverlappingWindows(const Trajectory& truth, const Trajectory& estimate,
                                            const Window& window) {
  if (truth.empty() || estimate.empty()) return {};
  const std::vector<double> truth_times = Times(truth);
  const double tolerance_s = 2 * MedianInterval(truth_times);
  const auto with_truth = [&](const StampedPose& pose) -> std::optional<PosePair> {
    const StampedPose& nearest = truth[NearestIndex(truth_times, pose.time_s)];
    if (std::abs(nearest.time_s - pose.time_s) > tolerance_s) return std::nullopt;
    return PosePair{nearest, pose};
  };
  const std::vector<double> covered = Covered(estimate, window.unit);
  std::vector<WindowPoses> windows;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const std::size_t j = NearestIndex(covered, covered[i] + window.length);
    if (j + 1 == estimate.size()) continue;
    const std::optional<PosePair> first = with_truth(estimate[i]), last = with_truth(estimate[j]);
    if (first && last) windows.push_back({*first, *last});
  }
  return windows;
}

SE3d WindowError(const WindowPoses& w, Convention convention) {
  const SE3d& qi = w.first.truth.world_from_camera;
  const SE3d& qj = w.last.truth.world_from_camera;
  const SE3d& pi = w.first.estimate.world_from_camera;
  const SE3d& pj = w.last.estimate.world_from_camera;
  return convention == Convention::kEvo ? (qi.Inverse() * qj).Inverse() * (pi.Inverse() * pj)
                                        : (pj.Inverse() * pi).Inverse() * (qj.Inverse() * qi);
}

}  // namespace

std::optional<RelativeError> RelativePoseError(const Trajectory& truth, const Trajectory& estimate,
                                               const Window& window, Convention convention) {
  const std::vector<WindowPoses> windows =
      convention == Convention::kEvo ? ConsecutiveWindows(AssociateLikeEvo(truth, estimate), window)
                                     : OverlappingWindows(truth, estimate, window);
  if (windows.empty()) return std::nullopt;
  std::vector<double> translation_m, rotation_deg;
  for (const WindowPoses& w : windows) {
    const SE3d error = WindowError(w, convention);
    translation_m.push_back(Norm(error.translation));
    rotation_deg.push_back(180 / std::numbers::pi * RotationAngle(error.rotation));
  }
  return RelativeError{window, Summarize(translation_m), Summarize(rotation_deg)};
}

}  // namespace silt::experiments
