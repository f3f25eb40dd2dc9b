// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/convergence_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "silt/core/formatted.h"

namespace silt::experiments {
namespace {

// What the paper says of a level; nothing of levels beyond its four.
std::optional<PaperCosts> PaperLevel(const ConvergenceRun& run, int level) {
  if (run.scheme == kFullResolution) return kPaperFullResolution;
  for (const PaperCosts& costs : kPaperTable1) {
    if (costs.level == level) return costs;
  }
  return {};
}

std::string FormatLevels(const ConvergenceRun& run) {
  std::string text;
  for (const tracker::AlignmentLevel& level : run.result.levels) {
    const std::optional<PaperCosts> paper = PaperLevel(run, level.level);
    text += Formatted("  %5d  %4d x %-4d %7d %12.4f %12.4f %9.3f", level.level, level.width,
                      level.height, level.iterations, level.initial_cost.sum, level.final_cost.sum,
                      CostRatio(level));
    text += paper ? Formatted(" %9.3f\n", CostRatio(*paper)) : "         -\n";
  }
  return text;
}

std::string FormatRun(const ConvergenceRun& run) {
  std::string text = run.scheme + "\n";
  text += "  level         size  solves      initial        final     ratio   paper's\n";
  text += FormatLevels(run);
  text += Formatted("  error: %.2f mm, %.3f deg at the start; %.3f mm, %.4f deg at the end\n",
                    1e3 * run.start_error.distance_m, run.start_error.angle_deg,
                    1e3 * run.end_error.distance_m, run.end_error.angle_deg);
  if (!run.result.ok) text += "  failed: " + run.result.failure + "\n";
  return text;
}

std::string FormatRate(const NamedSuccessRate& rate) {
  const SuccessRate& s = rate.success;
  const Interval interval = WilsonInterval(s.recovered, s.starts);
  return Formatted("  %-22s %6.1f cm %6.2f deg %5d of %-5d %4.0f %% (%.0f to %.0f)\n",
                   rate.scheme.c_str(), 100 * s.offset.distance_m, s.offset.angle_deg, s.recovered,
                   s.starts, 100 * s.rate(), 100 * interval.low, 100 * interval.high);
}

}  // namespace

Json LevelRows(const std::vector<ConvergenceRun>& runs) {
  Json rows = Json::array();
  for (const ConvergenceRun& run : runs) {
    for (const tracker::AlignmentLevel& level : run.result.levels) {
      const std::optional<PaperCosts> paper = PaperLevel(run, level.level);
      Json row{{"scheme", run.scheme},
               {"level", level.level},
               {"width", level.width},
               {"height", level.height},
               {"solves", level.iterations},
               {"converged", level.converged},
               {"initial_cost", level.initial_cost.sum},
               {"final_cost", level.final_cost.sum},
               {"initial_pixels", level.initial_cost.pixels},
               {"final_pixels", level.final_cost.pixels},
               {"ratio", CostRatio(level)}};
      row["paper_initial_cost"] = paper ? Json(paper->initial) : Json();
      row["paper_final_cost"] = paper ? Json(paper->final) : Json();
      row["paper_ratio"] = paper ? Json(CostRatio(*paper)) : Json();
      rows.push_back(row);
    }
  }
  return rows;
}

Json IterationRows(const std::vector<ConvergenceRun>& runs) {
  Json rows = Json::array();
  for (const ConvergenceRun& run : runs) {
    for (const tracker::AlignmentStep& step : run.result.log) {
      rows.push_back({{"scheme", run.scheme},
                      {"level", step.level},
                      {"iteration", step.iteration},
                      {"cost", step.cost.sum},
                      {"pixels", step.cost.pixels},
                      {"trial_cost", step.trial_cost.sum},
                      {"trial_pixels", step.trial_cost.pixels},
                      {"update_norm", step.update_norm},
                      {"damping", step.damping},
                      {"accepted", step.accepted}});
    }
  }
  return rows;
}

Json SuccessRows(const std::vector<NamedSuccessRate>& rates) {
  Json rows = Json::array();
  for (const NamedSuccessRate& rate : rates) {
    const SuccessRate& s = rate.success;
    Json row{{"scheme", rate.scheme},
             {"series", rate.series},
             {"distance_m", s.offset.distance_m},
             {"angle_deg", s.offset.angle_deg}};
    row.update(ToJson(s));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string FormatConvergence(const std::vector<ConvergenceRun>& runs,
                              const std::vector<NamedSuccessRate>& rates) {
  std::string text =
      "Convergence from T = [R_true, 0.6 t_true]: cost (half the sum of squares) per level.\n"
      "The paper's costs are of other pictures: compare the ratios initial / final.\n\n";
  for (const ConvergenceRun& run : runs) text += FormatRun(run) + "\n";
  if (rates.empty()) return text;
  text += Formatted("Recovered to %.0f mm and %.1f deg from random starts (95 %% interval):\n",
                    1e3 * kRecovered.distance_m, kRecovered.angle_deg);
  std::string series;
  for (const NamedSuccessRate& rate : rates) {
    if (rate.series != series) text += rate.series + "\n";
    series = rate.series;
    text += FormatRate(rate);
  }
  return text;
}

}  // namespace silt::experiments
