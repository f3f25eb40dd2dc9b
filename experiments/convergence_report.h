// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/convergence.h"
#include "silt/experiments/json.h"
#include "silt/experiments/success_rate.h"

namespace silt::experiments {

// A success rate of one scheme within a series of growing offsets.
struct NamedSuccessRate {
  std::string scheme, series;
  SuccessRate success;
};

// Lists of flat objects, for JSON and CSV alike. The paper's figures are null where it gives none.
Json LevelRows(const std::vector<ConvergenceRun>& runs);      // Table 1
Json IterationRows(const std::vector<ConvergenceRun>& runs);  // Fig. 4
Json SuccessRows(const std::vector<NamedSuccessRate>& rates);

// Table 1 with the paper's beside it, and the success rates, for people.
std::string FormatConvergence(const std::vector<ConvergenceRun>& runs,
                              const std::vector<NamedSuccessRate>& rates);

}  // namespace silt::experiments
