// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/accuracy.h"

namespace silt::experiments {

// The paper's Tables 2 and 3 with further columns beside the paper's, which come first in each
// group of columns.
struct ComparisonTable {
  struct Row {
    std::string label;
    std::vector<std::vector<std::string>> cells;  // per group, per column
  };
  std::string title;
  std::vector<std::string> groups;   // sequences
  std::vector<std::string> columns;  // of each group: "paper", then the presets
  std::vector<Row> rows;
};

// Table 2, and Table 3 axis by axis, of the runs of the first seed; then what the paper does not
// state (frames, keyframes, speed) and, of several seeds, the spread.
std::vector<ComparisonTable> ComparisonTables(const std::vector<AccuracyRun>& runs);

std::string FormatText(const ComparisonTable& table);
std::string FormatHtml(const ComparisonTable& table);

// "&" and angle brackets made harmless.
std::string EscapeHtml(const std::string& text);

}  // namespace silt::experiments
