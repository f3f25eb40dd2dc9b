// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/success_rate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "silt/core/random.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/statistics.h"

namespace silt::experiments {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Uniform on the unit sphere (Archimedes: z is uniform in [−1, 1]).
Vec3d Direction(const CounterRandom& random, std::uint64_t index) {
  const double z = 2 * random.Uniform(2 * index) - 1;
  const double phi = 2 * kPi * random.Uniform(2 * index + 1);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(phi), r * std::sin(phi), z};
}

int Solves(const tracker::AlignmentResult& result) {
  int solves = 0;
  for (const tracker::AlignmentLevel& level : result.levels) solves += level.iterations;
  return solves;
}

// A pair's starts from `first` on, so many as are aligned at once.
std::vector<SE3d> PosesOf(const SE3d& truth, const RandomStarts& starts, int pair, int first) {
  std::vector<SE3d> poses;
  for (int i = first; i < std::min(first + kStartsAtOnce, starts.count); ++i) {
    const int index = pair * starts.count + i;
    poses.push_back(RandomStart(truth, starts.OffsetOf(index), starts.seed, index));
  }
  return poses;
}

}  // namespace

SE3d RandomStart(const SE3d& truth, const PoseDifference& offset, std::uint64_t seed, int index) {
  const CounterRandom random(seed, std::uint64_t(index));
  SE3d reference_from_current = truth.Inverse();
  reference_from_current.translation += offset.distance_m * Direction(random, 0);
  const Vec3d omega = offset.angle_deg * kPi / 180 * Direction(random, 1);
  reference_from_current.rotation =
      (reference_from_current.rotation * Quaterniond::Exp(omega)).Normalized();
  return reference_from_current.Inverse();
}

Interval WilsonInterval(int successes, int trials) {
  if (trials <= 0) return {0, 1};
  constexpr double z = 1.959963985;
  const double n = trials, p = successes / n;
  const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Json ToJson(const SuccessRate& success) {
  const Interval interval = WilsonInterval(success.recovered, success.starts);
  return {{"starts", success.starts},   {"recovered", success.recovered},
          {"rate", success.rate()},     {"rate_low", interval.low},
          {"rate_high", interval.high}, {"median_solves", success.median_solves}};
}

PoseDifference RandomStarts::OffsetOf(int index) const {
  if (!up_to) return offset;
  // RandomStart draws its directions from the same stream, with the indices from 0 to 3.
  const CounterRandom random(seed, std::uint64_t(index));
  return {offset.distance_m * random.Uniform(4), offset.angle_deg * random.Uniform(5)};
}

SuccessRate MeasureSuccessRate(const std::vector<SE3d>& truths, const RandomStarts& starts,
                               const AlignAllFrom& align) {
  SuccessRate success{starts.offset, 0, 0, 0};
  std::vector<double> solves;
  const auto add = [&](std::size_t pair, const std::vector<SE3d>& poses) {
    ThrowIfInterrupted();
    for (const tracker::AlignmentResult& result : align(pair, poses)) {
      const PoseDifference error = Difference(truths[pair], result.current_from_reference);
      ++success.starts;
      success.recovered += result.ok && error.Within(kRecovered);
      solves.push_back(Solves(result));
    }
  };
  for (std::size_t p = 0; p < truths.size(); ++p) {
    for (int first = 0; first < starts.count; first += kStartsAtOnce) {
      add(p, PosesOf(truths[p], starts, int(p), first));
    }
  }
  if (!solves.empty()) success.median_solves = Median(solves);
  return success;
}

SuccessRate MeasureSuccessRate(const std::vector<SE3d>& truths, const RandomStarts& starts,
                               const AlignFrom& align) {
  const AlignAllFrom one_by_one = [&](std::size_t pair, const std::vector<SE3d>& poses) {
    std::vector<tracker::AlignmentResult> results;
    for (const SE3d& pose : poses) results.push_back(align(pair, pose));
    return results;
  };
  return MeasureSuccessRate(truths, starts, one_by_one);
}

SuccessRate MeasureSuccessRate(const std::vector<PairAlignment>& pairs, const RandomStarts& starts,
                               const tracker::AlignmentOptions& options) {
  // Nobody reads the logs, and a backend that runs alignments by itself keeps none.
  tracker::AlignmentOptions without_log = options;
  without_log.keep_log = false;
  std::vector<SE3d> truths;
  for (const PairAlignment& pair : pairs) truths.push_back(pair.truth());
  const AlignAllFrom all = [&](std::size_t pair, const std::vector<SE3d>& poses) {
    return pairs[pair].AlignAll(poses, without_log);
  };
  return MeasureSuccessRate(truths, starts, all);
}

}  // namespace silt::experiments
