// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/ablation.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "silt/core/formatted.h"

namespace silt::experiments {
namespace {

std::string SpecOf(const std::string& preset, const Alternative& alternative) {
  return alternative.changes.empty() ? preset : preset + ":" + alternative.changes;
}

AblationCell MeanOver(const std::vector<AccuracyRun>& runs, const std::string& sequence,
                      const std::string& preset) {
  AblationCell mean;
  int n = 0;
  for (const AccuracyRun& run : runs) {
    if (run.sequence.name != sequence || run.setup.preset != preset) continue;
    mean.position_rmse_cm += run.statistics.position_cm.rmse;
    mean.ate_aligned_cm += run.ate_aligned_cm;
    mean.lost += run.tracking.lost();
    mean.ms_per_frame += run.tracking.mean_times.total_ms;
    ++n;
  }
  n = std::max(n, 1);
  mean.position_rmse_cm /= n;
  mean.ate_aligned_cm /= n;
  mean.ms_per_frame /= n;
  return mean;
}

std::string FormatRow(const AblationRow& row) {
  std::string changes = row.alternative.changes.empty() ? "as it is" : row.alternative.changes;
  std::replace(changes.begin(), changes.end(), ':', ' ');
  std::string line = "| " + changes + " | " + row.alternative.meaning + " |";
  double ms = 0;
  for (const AblationCell& cell : row.cells) {
    line +=
        Formatted(" %.4f (%.4f) | ×%.2f |", cell.position_rmse_cm, cell.ate_aligned_cm, cell.ratio);
    if (cell.lost > 0) line.insert(line.size() - 2, Formatted(", %d lost", cell.lost));
    ms += cell.ms_per_frame;
  }
  return line + Formatted(" %.0f |\n", ms / double(std::max<std::size_t>(row.cells.size(), 1)));
}

}  // namespace

std::vector<Alternative> AlternativesTo(const std::string& preset) {
  const std::vector<Alternative> of_both{
      {"robust_scale=0:depth_residual=0", "squares, intensity alone"},
      {"depth_residual=0", "no residuals of the depth"},
      {"use_current_depth=0:depth_residual=0", "only keyframes have a depth"},
      {"exclude_hidden=0", "hidden pixels stay"},
      {"depth_edge_margin_px=0", "depth edges stay"},
      {"depth_edge_margin_px=4", "a wider margin at depth edges"},
      {"robust_scale=1.5", "a tighter norm"},
      {"robust_scale=4", "a looser norm"},
      {"robust_gradient=0", "steep gradients weigh as much as others"},
      {"max_distance_m=0.13", "keyframes as near as the paper's"},
      {"max_distance_m=0.3", "keyframes farther apart"},
      {"metres_per_radian=0:max_rotation_deg=30", "turns as the paper counts them"},
      {"always_initialize=1", "each frame starts from sparse features"},
      {"initial_damping=0", "Gauss-Newton"},
      {"initial_damping=0.1", "more damping"},
      {"scaled_damping=0", "damping as the paper adds it"},
      {"take_last_step=0", "steps below the least are not taken"},
      {"coarser_update_norm=1", "coarse levels stop as late as fine ones"},
      {"min_update_norm=1e-6", "stops as late as the paper"},
  };
  std::vector<Alternative> all;
  if (preset == "accurate") {
    all = of_both;
    all.push_back({"joint=1", "one keyframe at a time"});
    all.push_back({"joint=2", "two keyframes at once"});
    all.push_back({"joint=5", "five keyframes at once"});
    all.push_back({"max_iterations=0-5-10-20", "the iterations of `fast`"});
    all.push_back({"scale_rounds=1", "scales estimated once a level"});
  } else if (preset == "fast") {
    all = of_both;
    all.push_back({"joint=2", "two keyframes at once"});
    all.push_back({"max_iterations=6-6-10-10", "the iterations of `accurate`"});
    all.push_back({"max_iterations=2-5-10-20", "at full resolution too"});
    all.push_back({"scale_rounds=4", "scales estimated until they stay"});
  } else if (preset == "paper") {
    all = {{"exclude_hidden=0", "hidden pixels stay"},
           {"always_initialize=0", "starts from an even motion"},
           {"depth_edge_margin_px=2", "depth edges left out"},
           {"robust_scale=2.5", "a robust norm"},
           {"use_current_depth=1", "the current depth tells what is hidden"},
           {"joint=3", "three keyframes at once"},
           {"max_distance_m=0.2", "keyframes farther apart"},
           {"initial_damping=0", "Gauss-Newton"},
           {"max_iterations=6-6-10-10", "the iterations of `accurate`"}};
  }
  return all;
}

std::vector<AblationRow> RunAblation(const AccuracyOptions& accuracy, const std::string& preset,
                                     const std::vector<Alternative>& alternatives) {
  std::vector<AblationRow> rows{{{"", ""}, {}}};
  for (const Alternative& alternative : alternatives) rows.push_back({alternative, {}});
  AccuracyOptions options = accuracy;
  options.presets.clear();
  for (const AblationRow& row : rows) options.presets.push_back(SpecOf(preset, row.alternative));
  const AccuracyResult result = RunAccuracy(options);
  for (const PaperSequence& sequence : PaperSequences()) {
    for (AblationRow& row : rows) {
      AblationCell cell = MeanOver(result.runs, sequence.name, SpecOf(preset, row.alternative));
      const double own_cm = row.cells.size() < rows.front().cells.size()
                                ? rows.front().cells.back().position_rmse_cm
                                : cell.position_rmse_cm;
      cell.ratio = own_cm > 0 ? cell.position_rmse_cm / own_cm : 1;
      row.cells.push_back(cell);
    }
  }
  return rows;
}

std::string FormatMarkdown(const std::vector<AblationRow>& rows) {
  std::string header = "| changed | which means |", rule = "|---|---|";
  for (const PaperSequence& sequence : PaperSequences()) {
    header += " " + sequence.name + " | |";
    rule += "---|---|";
  }
  std::string table = header + " ms a frame |\n" + rule + "---|\n";
  for (const AblationRow& row : rows) table += FormatRow(row);
  return table;
}

Json ToJson(const std::vector<AblationRow>& rows) {
  Json all = Json::array();
  for (const AblationRow& row : rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const AblationCell& cell = row.cells[i];
      all.push_back({{"changed", row.alternative.changes},
                     {"sequence", PaperSequences()[i].name},
                     {"position_rmse_cm", cell.position_rmse_cm},
                     {"ratio", cell.ratio},
                     {"ate_aligned_cm", cell.ate_aligned_cm},
                     {"lost", cell.lost},
                     {"ms_per_frame", cell.ms_per_frame}});
    }
  }
  return all;
}

}  // namespace silt::experiments
