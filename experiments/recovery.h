// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/json.h"
#include "silt/experiments/pair_alignment.h"
#include "silt/experiments/success_rate.h"

// From how far away a preset's refinement alone, without features, finds the true motion.
namespace silt::experiments {

// A kind of random starts, and the share of them that ought to be recovered.
struct RecoverySet {
  PoseDifference bound;
  bool up_to = false;  // magnitudes uniform up to the bound, else at it
  double aim = 0;

  std::string Name() const;
};
inline constexpr RecoverySet kRecoverySets[] = {{{0.1, 5}, true, 0.99},
                                                {{0.1, 5}, false, 0.95},
                                                {{0.2, 10}, true, 0.90},
                                                {{0.2, 10}, false, 0.80}};

struct RecoveryOptions {
  std::vector<std::string> presets = {"paper", "accurate", "fast"};
  int starts = 1000;     // per set and preset, over all pairs
  int comparison = 100;  // the same of schemes that are there to be compared with
  std::uint64_t seed = 0;
};

// How a preset finds its way from a start that it does not trust, and what that is compared with:
// "wide start", where the preset has one, and then its pyramid; its pyramid; its finest level
// alone.
inline constexpr const char* kWideScheme = "wide start";
inline constexpr const char* kPyramidScheme = "pyramid";
inline constexpr const char* kSingleLevelScheme = "single level";

struct Recovery {
  std::string preset, scheme;
  RecoverySet set;
  SuccessRate success;
};

// Each pair gets an equal share of the starts, at least one.
std::vector<Recovery> MeasureRecovery(const std::vector<FramePair>& pairs,
                                      const tracker::Backend& backend,
                                      const RecoveryOptions& options);

// Lists of flat objects, for JSON and CSV alike: rates with 95 % intervals, and what the pairs
// show.
Json RecoveryRows(const std::vector<Recovery>& recoveries);
Json PairRows(const std::vector<FramePair>& pairs);

std::string FormatRecovery(const std::vector<Recovery>& recoveries,
                           const std::vector<FramePair>& pairs);

}  // namespace silt::experiments
