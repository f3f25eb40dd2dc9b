// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/association.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "silt/core/error.h"

namespace silt::experiments {

std::vector<double> Times(const Trajectory& trajectory) {
  std::vector<double> times;
  for (const StampedPose& pose : trajectory) times.push_back(pose.time_s);
  return times;
}

std::size_t NearestIndex(const std::vector<double>& ascending, double wanted) {
  SILT_CHECK(!ascending.empty());
  const auto after = std::lower_bound(ascending.begin(), ascending.end(), wanted);
  if (after == ascending.begin()) return 0;
  // The value before may repeat: the first of its run.
  const auto before = std::lower_bound(ascending.begin(), after, *(after - 1));
  const bool before_is_nearer = after == ascending.end() || wanted - *before <= *after - wanted;
  return std::size_t((before_is_nearer ? before : after) - ascending.begin());
}

std::vector<PosePair> AssociateLikeEvo(const Trajectory& truth, const Trajectory& estimate,
                                       double tolerance_s) {
  const bool estimate_is_longer = estimate.size() > truth.size();
  const Trajectory& shorter = estimate_is_longer ? truth : estimate;
  const Trajectory& longer = estimate_is_longer ? estimate : truth;
  std::vector<PosePair> pairs;
  if (longer.empty()) return pairs;
  const std::vector<double> times = Times(longer);
  for (const StampedPose& pose : shorter) {
    const StampedPose& nearest = longer[NearestIndex(times, pose.time_s)];
    if (!(std::abs(nearest.time_s - pose.time_s) <= tolerance_s)) continue;
    pairs.push_back(estimate_is_longer ? PosePair{pose, nearest} : PosePair{nearest, pose});
  }
  return pairs;
}

std::vector<PosePair> AssociateLikeTum(const Trajectory& truth, const Trajectory& estimate,
                                       double tolerance_s) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  std::size_t first = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double time_s = truth[i].time_s;
    while (first < estimate.size() && estimate[first].time_s <= time_s - tolerance_s) ++first;
    for (std::size_t j = first; j < estimate.size(); ++j) {
      const double apart_s = std::abs(time_s - estimate[j].time_s);
      if (estimate[j].time_s > time_s && apart_s >= tolerance_s) break;
      if (apart_s < tolerance_s) candidates.emplace_back(apart_s, i, j);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  constexpr std::size_t kFree = std::size_t(-1);
  std::vector<std::size_t> estimate_of(truth.size(), kFree);
  std::vector<bool> taken(estimate.size(), false);
  for (const auto& [apart_s, i, j] : candidates) {
    if (estimate_of[i] != kFree || taken[j]) continue;
    estimate_of[i] = j;
    taken[j] = true;
  }
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (estimate_of[i] != kFree) pairs.push_back({truth[i], estimate[estimate_of[i]]});
  }
  return pairs;
}

std::vector<PosePair> Associate(const Trajectory& truth, const Trajectory& estimate,
                                Convention convention) {
  return convention == Convention::kEvo ? AssociateLikeEvo(truth, estimate)
                                        : AssociateLikeTum(truth, estimate);
}

}  // namespace silt::experiments
