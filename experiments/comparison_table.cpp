// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/comparison_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "silt/experiments/paper_values.h"

namespace silt::experiments {
namespace {

std::string Digits(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// An error: three decimals, as the paper has at most, and more for what is small.
std::string ErrorDigits(double value) {
  const double size = std::abs(value);
  return Digits(size >= 0.01 || size == 0 ? "%.3f" : size >= 0.0001 ? "%.4f" : "%.5f", value);
}

// One statistic: its name, and where it stands in our and in the paper's columns.
struct Line {
  const char* label;
  double Statistics::*ours;
  const char* PaperColumn::*papers;
};

constexpr Line kLines[] = {
    {"RMSE", &Statistics::rmse, &PaperColumn::rmse},
    {"Max. error", &Statistics::max, &PaperColumn::max},
    {"Min. error", &Statistics::min, &PaperColumn::min},
    {"Mean error", &Statistics::mean, &PaperColumn::mean},
    {"Median error", &Statistics::median, &PaperColumn::median},
    {"Standard dev.", &Statistics::std_dev, &PaperColumn::std_dev},
};

// Runs by sequence and preset, each with all its seeds.
class RunTable {
 public:
  explicit RunTable(const std::vector<AccuracyRun>& runs) : runs_(runs) {
    for (const AccuracyRun& run : runs) {
      AddOnce(sequences, run.sequence.name);
      AddOnce(presets, run.setup.preset);
    }
  }

  std::vector<const AccuracyRun*> Find(const std::string& sequence,
                                       const std::string& preset) const {
    std::vector<const AccuracyRun*> found;
    for (const AccuracyRun& run : runs_) {
      if (run.sequence.name == sequence && run.setup.preset == preset) found.push_back(&run);
    }
    return found;
  }

  std::vector<std::string> sequences, presets;

 private:
  static void AddOnce(std::vector<std::string>& list, const std::string& name) {
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  }

  const std::vector<AccuracyRun>& runs_;
};

ComparisonTable Empty(const RunTable& runs, const std::string& title) {
  ComparisonTable table{title, runs.sequences, {"paper"}, {}};
  for (const std::string& preset : runs.presets) {
    table.columns.push_back(runs.presets.size() == 1 ? "silt" : "silt " + preset);
  }
  return table;
}

using Cell = std::function<std::string(const std::vector<const AccuracyRun*>& seeds)>;

// One row of `papers` value (by sequence) and ours.
void AddRow(ComparisonTable& table, const RunTable& runs, const std::string& label,
            const std::function<std::string(const std::string&)>& papers, const Cell& ours) {
  ComparisonTable::Row row{label, {}};
  for (const std::string& sequence : runs.sequences) {
    std::vector<std::string> cells{papers(sequence)};
    for (const std::string& preset : runs.presets) {
      const auto seeds = runs.Find(sequence, preset);
      cells.push_back(seeds.empty() ? "" : ours(seeds));
    }
    row.cells.push_back(std::move(cells));
  }
  table.rows.push_back(std::move(row));
}

std::string None(const std::string&) { return ""; }

ComparisonTable PositionTable(const RunTable& runs) {
  ComparisonTable table = Empty(runs, "Table 2. Error of the camera's position [cm]");
  for (const Line& line : kLines) {
    if (line.ours == &Statistics::min) continue;  // the paper states none
    const auto papers = [&](const std::string& sequence) {
      const PaperColumn* column = PaperPosition(sequence);
      return column ? std::string(column->*line.papers) : "";
    };
    AddRow(table, runs, line.label, papers, [&](const auto& seeds) {
      return ErrorDigits(seeds.front()->statistics.position_cm.*line.ours);
    });
  }
  AddRow(table, runs, "ATE RMSE, aligned", None,
         [](const auto& seeds) { return ErrorDigits(seeds.front()->ate_aligned_cm); });
  return table;
}

ComparisonTable OrientationTable(const RunTable& runs, int axis) {
  const char name[] = {"XYZ"[axis], '\0'};
  ComparisonTable table = Empty(
      runs, std::string("Table 3. Error of the camera's orientation about ") + name + " [deg]");
  for (const Line& line : kLines) {
    const auto papers = [&](const std::string& sequence) {
      const PaperColumn* column = PaperOrientation(sequence, axis);
      return column ? std::string(column->*line.papers) : "";
    };
    AddRow(table, runs, line.label, papers, [&](const auto& seeds) {
      return ErrorDigits(seeds.front()->statistics.orientation_deg[axis].*line.ours);
    });
  }
  return table;
}

ComparisonTable RunFacts(const RunTable& runs) {
  ComparisonTable table = Empty(runs, "The runs");
  const auto add = [&](const char* label, const char* format, auto value, const char* papers) {
    AddRow(
        table, runs, label, [&](const std::string&) { return std::string(papers); },
        [&](const auto& seeds) { return Digits(format, double(value(*seeds.front()))); });
  };
  add(
      "Frames", "%.0f", [](const AccuracyRun& r) { return r.tracking.estimate.size(); }, "");
  add(
      "Path [m]", "%.3f", [](const AccuracyRun& r) { return PathLength(r.truth); }, "6.93");
  add(
      "Keyframes", "%.0f", [](const AccuracyRun& r) { return r.tracking.keyframes(); }, "");
  add(
      "Frames lost", "%.0f", [](const AccuracyRun& r) { return r.tracking.lost(); }, "");
  add(
      "Time per frame [ms]", "%.1f",
      [](const AccuracyRun& r) { return r.tracking.mean_times.total_ms; }, "100");
  return table;
}

std::vector<double> PositionRmse(const std::vector<const AccuracyRun*>& seeds) {
  std::vector<double> values;
  for (const AccuracyRun* run : seeds) values.push_back(run->statistics.position_cm.rmse);
  return values;
}

ComparisonTable Spread(const RunTable& runs, std::size_t seeds) {
  ComparisonTable table = Empty(runs, "RMSE of the position over " + std::to_string(seeds) +
                                          " seeds of noise and draws [cm]");
  const auto papers = [](const std::string& sequence) {
    const PaperColumn* column = PaperPosition(sequence);
    return column ? std::string(column->rmse) : "";
  };
  const auto add = [&](const char* label, double Statistics::*member, const auto& of_paper) {
    AddRow(table, runs, label, of_paper,
           [member](const auto& of) { return ErrorDigits(Summarize(PositionRmse(of)).*member); });
  };
  add("Mean", &Statistics::mean, papers);
  add("Standard dev.", &Statistics::std_dev, None);
  add("Lowest", &Statistics::min, None);
  add("Highest", &Statistics::max, None);
  return table;
}

}  // namespace

std::vector<ComparisonTable> ComparisonTables(const std::vector<AccuracyRun>& runs) {
  const RunTable table(runs);
  std::vector<ComparisonTable> tables{PositionTable(table)};
  for (int axis = 0; axis < 3; ++axis) tables.push_back(OrientationTable(table, axis));
  std::size_t seeds = 0;
  for (const std::string& sequence : table.sequences) {
    seeds = std::max(seeds, table.Find(sequence, table.presets.front()).size());
  }
  if (seeds > 1) tables.push_back(Spread(table, seeds));
  tables.push_back(RunFacts(table));
  return tables;
}

}  // namespace silt::experiments
