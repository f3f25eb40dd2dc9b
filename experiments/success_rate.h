// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "silt/experiments/json.h"
#include "silt/experiments/pair_alignment.h"
#include "silt/experiments/pose_difference.h"
#include "silt/experiments/statistics.h"
#include "silt/tracker/options.h"

namespace silt::experiments {

// An aligned pose counts as recovered up to this error.
inline constexpr PoseDifference kRecovered{1e-3, 0.1};

// The true pose, with the camera moved by exactly this distance in a random direction and turned by
// exactly this angle about a random axis. A pure function of its arguments.
SE3d RandomStart(const SE3d& truth, const PoseDifference& offset, std::uint64_t seed, int index);

struct SuccessRate {
  PoseDifference offset;  // of the starts
  int starts = 0, recovered = 0;
  double median_solves = 0;  // over all levels
  double rate() const { return starts > 0 ? double(recovered) / starts : 0; }
};

// 95 % interval of a rate (Wilson's, which holds near 0 and 1 too).
Interval WilsonInterval(int successes, int trials);
// The counts, the rate with its interval, and the solves.
Json ToJson(const SuccessRate& success);

struct RandomStarts {
  PoseDifference offset;
  int count = 10;  // per pair
  std::uint64_t seed = 0;
  bool up_to = false;  // each start's distance and angle are uniform below those of the offset

  PoseDifference OffsetOf(int index) const;
};

// Aligns a pair, given by its index, from a start.
using AlignFrom = std::function<tracker::AlignmentResult(std::size_t pair, const SE3d& start)>;
// The same from many starts.
using AlignAllFrom = std::function<std::vector<tracker::AlignmentResult>(
    std::size_t pair, const std::vector<SE3d>& starts)>;

// So many starts are aligned together at most, before an interruption is looked for; a large GPU
// takes several rounds for as many.
inline constexpr int kStartsAtOnce = 2048;

// The share of random starts from which the alignment recovers the true motion, over all pairs.
SuccessRate MeasureSuccessRate(const std::vector<SE3d>& truths, const RandomStarts& starts,
                               const AlignFrom& align);
SuccessRate MeasureSuccessRate(const std::vector<SE3d>& truths, const RandomStarts& starts,
                               const AlignAllFrom& align);
// All starts of a pair at once, as far as the backend can.
SuccessRate MeasureSuccessRate(const std::vector<PairAlignment>& pairs, const RandomStarts& starts,
                               const tracker::AlignmentOptions& options);

}  // namespace silt::experiments
