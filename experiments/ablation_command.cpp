// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/ablation.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/tracker_options.h"

namespace silt::experiments {
namespace {

struct Options {
  ExperimentBasics basics;
  std::string preset = "accurate", depth_sensor = "perfect";
  std::vector<std::string> changes;
  std::vector<std::filesystem::path> folders;
  double start_s = 4, duration_s = 3;
  int seeds = 1;
};

AccuracyOptions AccuracyOf(const Options& options, const ExperimentBasics& basics) {
  AccuracyOptions o;
  o.scene = basics.scene;
  o.trajectory = basics.trajectory;
  o.start_s = basics.quick ? 0 : options.start_s;
  o.duration_s = basics.quick ? 0.3 : options.duration_s;
  o.width = basics.width;
  o.samples_per_pixel = basics.samples_per_pixel;
  o.seeds = options.seeds;
  o.seed = basics.seed;
  o.backend = basics.backend;
  o.depth_sensor = options.depth_sensor;
  return o;
}

std::vector<Alternative> Asked(const Options& options) {
  std::vector<Alternative> alternatives;
  for (const std::string& changes : options.changes) alternatives.push_back({changes, ""});
  if (alternatives.empty()) alternatives = AlternativesTo(options.preset);
  if (alternatives.empty()) {
    throw Error("ablation: nothing is known that might be done otherwise in preset " +
                Quoted(options.preset) + "; give --change");
  }
  // Refused before anything is rendered.
  for (const Alternative& each : alternatives) PresetOptions(options.preset + ":" + each.changes);
  return alternatives;
}

void Run(const Options& options, const Invocation& invocation) {
  const ExperimentBasics basics = options.basics.Resolved();
  SetThreadCount(basics.threads);
  const std::vector<Alternative> alternatives = Asked(options);
  OutputFolder folder(basics.out);
  const AccuracyOptions accuracy = AccuracyOf(options, basics);
  const bool recorded = !options.folders.empty();
  const std::vector<AblationRow> rows =
      recorded ? RunAblation({options.folders, basics.backend}, options.preset, alternatives)
               : RunAblation(accuracy, options.preset, alternatives);
  const Json source = recorded ? Json{{"folders", options.folders}, {"backend", basics.backend}}
                               : accuracy.ToJson();
  const Json config{{recorded ? "recorded" : "accuracy", source},
                    {"preset", options.preset},
                    {"options", ToJson(PresetOptions(options.preset))}};
  const Json manifest = MakeManifest(invocation.command_line, config, accuracy.seed);
  const std::string table = FormatMarkdown(rows);
  WriteJson(folder.path() / "ablation.json", {{"manifest", manifest}, {"rows", ToJson(rows)}});
  WriteFileAtomically(folder.path() / "ablation.csv", FormatCsv(ToJson(rows)));
  WriteFileAtomically(folder.path() / "ablation.md", table);
  folder.Commit(manifest);
  Print(table + "Results: " + basics.out + "\n");
}

}  // namespace

void AddAblationExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "ablation", "A preset beside itself with one choice made otherwise, on the three sequences");
  AddExperimentBasics(*command, options->basics);
  command->add_option("--preset", options->preset, "Preset that is looked at")
      ->capture_default_str();
  command->add_option("--change", options->changes,
                      "What to try instead of the list that is known, such as joint=1 or "
                      "robust_scale=0:depth_residual=0; several with spaces");
  command->add_option(
      "--folder", options->folders,
      "Track the sequences in these folders, several with spaces, instead of the\n"
      "three: they are rendered once (silt render --format raw), and may be of any\n"
      "scene and sensor");
  RequireNumber(command->add_option("--start", options->start_s, "Start of the stretch [s]")
                    ->capture_default_str(),
                0, 1e6);
  RequireNumber(command->add_option("--duration", options->duration_s, "Its length [s]")
                    ->capture_default_str(),
                0.1, 1e6);
  RequireInteger(command->add_option("--seeds", options->seeds, "Mean over so many noises")
                     ->capture_default_str(),
                 1, 1000);
  command->add_option("--depth-sensor", options->depth_sensor, "As silt experiment accuracy has it")
      ->capture_default_str();
  command->footer(
      "Position RMSE in cm, first poses made equal, and its multiple of the preset's own, of "
      "which\n"
      "`mean` is the geometric mean. Times are of trackers that run one after another on the same\n"
      "frames. Example: silt experiment ablation --preset fast --change joint=1 joint=2 --out abl");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
