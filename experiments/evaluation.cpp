// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/evaluation.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

Trajectory TruthOf(const std::vector<PosePair>& pairs) {
  Trajectory truth;
  for (const PosePair& pair : pairs) truth.push_back(pair.truth);
  return truth;
}

const char* Name(WindowUnit unit) {
  return unit == WindowUnit::kFrames ? "frames" : unit == WindowUnit::kSeconds ? "s" : "m";
}

Json ToJson(const std::optional<RelativeError>& error) {
  if (!error) return nullptr;
  return {{"delta", error->window.length},
          {"unit", Name(error->window.unit)},
          {"pairs", error->translation_m.count},
          {"translation_m", ToJson(error->translation_m)},
          {"rotation_deg", ToJson(error->rotation_deg)}};
}

std::string Row(const std::string& label, const Statistics& s, const char* unit) {
  char line[200];
  std::snprintf(line, sizeof line, "  %-22s %11.6f %11.6f %11.6f %11.6f %11.6f %11.6f  %s\n",
                label.c_str(), s.rmse, s.mean, s.median, s.std_dev, s.min, s.max, unit);
  return line;
}

std::string RelativeRows(const std::optional<RelativeError>& error) {
  if (!error) return "";
  char window[48];
  std::snprintf(window, sizeof window, "RPE per %g %s", error->window.length,
                Name(error->window.unit));
  std::string label = window;
  if (label == "RPE per 1 s") label = "RPE per second";
  if (label == "RPE per 1 m") label = "RPE per metre";
  return Row(label, error->translation_m, "m") +
         Row("  " + std::to_string(error->translation_m.count) + " windows", error->rotation_deg,
             "deg");
}

}  // namespace

Json ToJson(const Statistics& s) {
  return {{"rmse", s.rmse}, {"max", s.max},       {"min", s.min},
          {"mean", s.mean}, {"median", s.median}, {"std", s.std_dev}};
}

Evaluation Evaluate(const Trajectory& truth, const Trajectory& estimate,
                    const EvaluationOptions& options) {
  const std::vector<PosePair> pairs = Associate(truth, estimate, options.convention);
  if (pairs.empty()) {
    throw Error("the two trajectories share no time: are their clocks the same, in seconds?");
  }
  const auto relative = [&](double length, WindowUnit unit) {
    return RelativePoseError(truth, estimate, {length, unit}, options.convention);
  };
  return {options.convention,
          int(pairs.size()),
          PathLength(TruthOf(pairs)),
          SummarizePaperErrors(PaperErrors(pairs)),
          AlignedTrajectoryError(pairs),
          relative(options.frames, WindowUnit::kFrames),
          relative(options.seconds, WindowUnit::kSeconds),
          relative(options.metres, WindowUnit::kMetres)};
}

Json ToJson(const Evaluation& e) {
  return {{"convention", e.convention == Convention::kEvo ? "evo" : "tum"},
          {"pairs", e.pairs},
          {"path_m", e.path_m},
          {"position_cm", ToJson(e.paper.position_cm)},
          {"orientation_deg",
           {{"x", ToJson(e.paper.orientation_deg[0])},
            {"y", ToJson(e.paper.orientation_deg[1])},
            {"z", ToJson(e.paper.orientation_deg[2])}}},
          {"ate_aligned_m", ToJson(e.aligned_m)},
          {"rpe",
           {{"per_frames", ToJson(e.per_frames)},
            {"per_second", ToJson(e.per_seconds)},
            {"per_metre", ToJson(e.per_metres)}}}};
}

std::string FormatEvaluation(const Evaluation& e) {
  char head[200];
  std::snprintf(
      head, sizeof head, "%d pairs (%s), %.3f m\n  %-22s %11s %11s %11s %11s %11s %11s\n", e.pairs,
      e.convention == Convention::kEvo ? "as evo, within 0.01 s" : "as TUM, within 0.02 s",
      e.path_m, "", "rmse", "mean", "median", "std", "min", "max");
  return head + Row("position, first = true", e.paper.position_cm, "cm") +
         Row("orientation about x", e.paper.orientation_deg[0], "deg") +
         Row("            about y", e.paper.orientation_deg[1], "deg") +
         Row("            about z", e.paper.orientation_deg[2], "deg") +
         Row("ATE, rigidly aligned", e.aligned_m, "m") + RelativeRows(e.per_frames) +
         RelativeRows(e.per_seconds) + RelativeRows(e.per_metres);
}

}  // namespace silt::experiments
