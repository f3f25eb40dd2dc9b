// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/ablation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "silt/core/error.h"
#include "silt/core/formatted.h"
#include "silt/core/io/sequence_format.h"
#include "silt/experiments/association.h"
#include "silt/experiments/evaluation.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/tracking_run.h"

namespace silt::experiments {
namespace {

AblationCell MeanOver(const std::vector<AccuracyRun>& runs, const std::string& sequence,
                      const std::string& preset) {
  AblationCell mean;
  mean.sequence = sequence;
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

// Hands each frame to one tracker after the other.
std::vector<AblationCell> TrackAll(const std::filesystem::path& folder, const std::string& backend,
                                   const std::vector<std::string>& presets) {
  const auto sequence = OpenSequence("auto", folder);
  const Trajectory& truth = sequence->truth();
  if (truth.empty()) {
    throw Error("ablation: " + folder.string() + " has no true poses to measure errors by");
  }
  const double start_s = sequence->times_s().front();
  const SE3d first = truth[NearestIndex(Times(truth), start_s)].world_from_camera;
  std::vector<std::unique_ptr<TrackingRun>> runs;
  for (const std::string& preset : presets) {
    const TrackerSetup setup{preset, backend};
    runs.push_back(std::make_unique<TrackingRun>(sequence->camera(), setup, first));
  }
  while (const std::optional<Frame> frame = sequence->Next()) {
    ThrowIfInterrupted();
    for (const auto& run : runs) run->Track(*frame);
  }
  std::vector<AblationCell> cells;
  for (const auto& run : runs) {
    const TrackingResult result = run->Result();
    const Evaluation evaluation = Evaluate(truth, result.estimate);
    cells.push_back({folder.filename().string(), evaluation.paper.position_cm.rmse,
                     100 * evaluation.aligned_m.rmse, 1, result.lost(),
                     result.mean_times.total_ms});
  }
  return cells;
}

std::vector<AblationRow> RowsFor(const std::vector<Alternative>& alternatives) {
  std::vector<AblationRow> rows{{{"", ""}, {}}};
  for (const Alternative& alternative : alternatives) rows.push_back({alternative, {}});
  return rows;
}

// What the trackers are called by.
std::vector<std::string> SpecsOf(const std::string& preset, const std::vector<AblationRow>& rows) {
  std::vector<std::string> specs;
  for (const AblationRow& row : rows) {
    const std::string& changes = row.alternative.changes;
    specs.push_back(changes.empty() ? preset : preset + ":" + changes);
  }
  return specs;
}

// One cell for each row, the preset's own first.
void AddCells(std::vector<AblationCell> cells, std::vector<AblationRow>* rows) {
  const double own_cm = cells.front().position_rmse_cm;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    cells[i].ratio = own_cm > 0 ? cells[i].position_rmse_cm / own_cm : 1;
    (*rows)[i].cells.push_back(cells[i]);
  }
}

std::string FormatRow(const AblationRow& row) {
  std::string changes = row.alternative.changes.empty() ? "as it is" : row.alternative.changes;
  std::replace(changes.begin(), changes.end(), ':', ' ');
  std::string line = "| " + changes + " | " + row.alternative.meaning + " |";
  double ms = 0;
  for (const AblationCell& cell : row.cells) {
    line += Formatted(" %.4f ×%.2f", cell.position_rmse_cm, cell.ratio);
    line += cell.lost > 0 ? Formatted(", %d lost |", cell.lost) : " |";
    ms += cell.ms_per_frame;
  }
  return line + Formatted(" ×%.2f | %.1f |\n", row.MeanRatio(),
                          ms / double(std::max<std::size_t>(row.cells.size(), 1)));
}

}  // namespace

std::vector<Alternative> AlternativesTo(const std::string& preset) {
  const std::vector<Alternative> of_both{
      {"robust_scale=0:depth_residual=0", "squares, intensity alone"},
      {"depth_residual=0", "no residuals of the depth"},
      {"use_current_depth=0:depth_residual=0", "only keyframes have a depth"},
      {"exclude_hidden=0", "hidden pixels stay"},
      {"max_disagreement=0", "intensities count in full, registered or not"},
      {"registered_contrast=0", "those that contradict depths lose weight, registered or not"},
      {"depth_edge_margin_px=0", "depth edges stay"},
      {"depth_edge_margin_px=4", "a wider margin at depth edges"},
      {"robust_scale=1.5", "a tighter norm"},
      {"robust_scale=4", "a looser norm"},
      {"robust_loss=huber:robust_scale=1.345", "Huber's norm"},
      {"robust_loss=tukey:robust_scale=4.685", "Tukey's norm"},
      {"robust_loss=student-t:robust_scale=2.236", "Student's t of five degrees of freedom"},
      {"robust_gradient=0", "steep gradients weigh as much as others"},
      {"max_distance_m=0.13", "keyframes as near as the paper's"},
      {"max_distance_m=0.3", "keyframes farther apart"},
      {"min_keyframe_overlap=0", "keyframes by distance alone"},
      {"min_keyframe_overlap=0.7:max_distance_m=1000", "keyframes by overlap alone"},
      {"min_keyframe_overlap=0.85:max_distance_m=1000", "the same, closer together"},
      {"metres_per_radian=0:max_rotation_deg=30", "turns as the paper counts them"},
      {"always_initialize=1", "each frame starts from sparse features"},
      {"initial_damping=0", "Gauss-Newton"},
      {"initial_damping=0.1", "more damping"},
      {"scaled_damping=0", "damping as the paper adds it"},
      {"take_last_step=0", "steps below the least are not taken"},
      {"coarser_update_norm=1", "coarse levels stop as late as fine ones"},
      {"min_update_norm=1e-6", "stops as late as the paper"},
      {"start=previous", "starts where the last frame was"},
      {"affine_brightness=1", "a gain and an offset for each keyframe"},
      {"reference_gradient=0.5", "both images' gradients, as ESM has them"},
      {"reference_gradient=1", "the keyframe's, as the inverse compositional has them"},
      {"interpolant=catmull-rom", "cubics through 4×4 pixels"},
      {"interpolant=b-spline", "cubic B-splines"},
      {"depth_residual=0:interpolant=catmull-rom", "intensity alone, by cubics"},
      {"depth_residual=0:interpolant=b-spline", "intensity alone, by B-splines"},
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
    all.push_back({"max_iterations=6-6-15-20", "the iterations of `accurate`"});
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
           {"interpolant=catmull-rom", "cubics through 4×4 pixels"},
           {"interpolant=b-spline", "cubic B-splines"},
           {"max_iterations=6-6-15-20", "the iterations of `accurate`"}};
  }
  return all;
}

double AblationRow::MeanRatio() const {
  double log_sum = 0;
  for (const AblationCell& cell : cells) log_sum += std::log(cell.ratio);
  return std::exp(log_sum / double(std::max<std::size_t>(cells.size(), 1)));
}

std::vector<AblationRow> RunAblation(const AccuracyOptions& accuracy, const std::string& preset,
                                     const std::vector<Alternative>& alternatives) {
  std::vector<AblationRow> rows = RowsFor(alternatives);
  AccuracyOptions options = accuracy;
  options.presets = SpecsOf(preset, rows);
  const AccuracyResult result = RunAccuracy(options);
  for (const PaperSequence& sequence : PaperSequences()) {
    std::vector<AblationCell> cells;
    for (const std::string& spec : options.presets) {
      cells.push_back(MeanOver(result.runs, sequence.name, spec));
    }
    AddCells(cells, &rows);
  }
  return rows;
}

std::vector<AblationRow> RunAblation(const RecordedSequences& recorded, const std::string& preset,
                                     const std::vector<Alternative>& alternatives) {
  std::vector<AblationRow> rows = RowsFor(alternatives);
  for (const std::filesystem::path& folder : recorded.folders) {
    AddCells(TrackAll(folder, recorded.backend, SpecsOf(preset, rows)), &rows);
  }
  return rows;
}

std::string FormatMarkdown(const std::vector<AblationRow>& rows) {
  std::string header = "| changed | which means |", rule = "|---|---|";
  for (const AblationCell& cell : rows.front().cells) {
    header += " " + cell.sequence + " |";
    rule += "---|";
  }
  std::string table = header + " mean | ms a frame |\n" + rule + "---|---|\n";
  for (const AblationRow& row : rows) table += FormatRow(row);
  return table;
}

Json ToJson(const std::vector<AblationRow>& rows) {
  Json all = Json::array();
  for (const AblationRow& row : rows) {
    for (const AblationCell& cell : row.cells) {
      all.push_back({{"changed", row.alternative.changes},
                     {"sequence", cell.sequence},
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
