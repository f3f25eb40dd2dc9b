// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/initialization.h"
#include "silt/experiments/json.h"

namespace silt::experiments {

// One case's outcomes, and what case it was.
struct InitializationRecord {
  std::string condition;  // sharp, noisy, blurred
  int gap = 0;            // frames from the keyframe to the current frame
  double keyframe_time_s = 0;
  std::vector<StartOutcome> outcomes;
};

// Lists of flat objects, for JSON and CSV alike: every outcome by itself, and medians and success
// rates per condition, gap and method, in the order in which conditions and gaps come up.
Json CaseRows(const std::vector<InitializationRecord>& records);
Json SummaryRows(const std::vector<InitializationRecord>& records);

// The summary rows as a table for people.
std::string FormatInitialization(const Json& summary_rows);

}  // namespace silt::experiments
