// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/accuracy.h"
#include "silt/experiments/accuracy_output.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/comparison_table.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/tracker_setup.h"
#include "silt/sim/depth_sensor.h"

namespace silt::experiments {
namespace {

constexpr double kFirstStretch_s = 2, kQuickStretch_s = 0.5;

struct Options {
  AccuracyOptions accuracy;
  bool full = false, quick = false;
  int threads = 0;
  std::string out;
};

// --quick and --full stand for what was not asked for itself.
AccuracyOptions Resolved(const Options& options) {
  if (options.full && options.quick) throw Error("accuracy: give --full or --quick, not both");
  AccuracyOptions o = options.accuracy;
  if (o.scene.empty()) o.scene = options.quick ? "studio" : "office";
  if (options.full) o.duration_s = 0;
  if (!options.full && o.duration_s == 0) {
    o.duration_s = options.quick ? kQuickStretch_s : kFirstStretch_s;
  }
  if (o.width == 0) o.width = options.quick ? 320 : 640;
  return o;
}

// The resolved options of each preset; runs differ in seed besides.
Json TrackerConfigs(const std::vector<AccuracyRun>& runs) {
  Json configs = Json::object();
  for (const AccuracyRun& run : runs) configs[run.setup.preset] = ToJson(run.setup);
  return configs;
}

void Run(const Options& options, const Invocation& invocation) {
  const AccuracyOptions accuracy = Resolved(options);
  SetThreadCount(options.threads);
  OutputFolder folder(options.out);
  const AccuracyResult result = RunAccuracy(accuracy);
  const Json config{{"accuracy", accuracy.ToJson()},
                    {"world", result.world.ToJson()},
                    {"sharp", result.plans[0].ToJson()},
                    {"blurred", result.plans[1].ToJson()},
                    {"trackers", TrackerConfigs(result.runs)}};
  const Json manifest = MakeManifest(invocation.command_line, config, accuracy.seed);
  WriteAccuracy(folder.path(), result, manifest);
  folder.Commit(manifest);
  std::string text;
  for (const ComparisonTable& table : ComparisonTables(result.runs)) {
    text += FormatText(table) + "\n";
  }
  Print(text + "Report: " + options.out + "/report.html\n");
}

void AddOptions(CLI::App& command, Options& o) {
  command.add_option("--out", o.out, "Folder to make; silt's own earlier results are replaced")
      ->required();
  command.add_flag("--full", o.full, "The whole path instead of its first 2 s");
  command.add_flag("--quick", o.quick, "0.5 s of the studio at 320x240: to see that all works");
  command.add_option("--scene", o.accuracy.scene, "Scene by name or path; default: office");
  command.add_option("--trajectory", o.accuracy.trajectory,
                     "Camera path by name or path; default: desk, or the only one");
  RequireNumber(command.add_option("--start", o.accuracy.start_s, "Start of the stretch [s]")
                    ->capture_default_str(),
                0, 1e6);
  RequireNumber(command.add_option("--duration", o.accuracy.duration_s, "Its length [s]"), 0.1,
                1e6);
  RequireInteger(
      command
          .add_option("--seeds", o.accuracy.seeds, "Repeat with so many noises and random draws")
          ->capture_default_str(),
      1, 1000);
  RequireInteger(
      command.add_option("--seed", o.accuracy.seed, "The first seed")->capture_default_str(), 0,
      1000000000);
  RequireInteger(command.add_option("--spp", o.accuracy.samples_per_pixel, "Samples per pixel")
                     ->capture_default_str(),
                 1, 4096);
  RequireInteger(command.add_option("--width", o.accuracy.width, "Width of the image"), 64, 8192);
  command
      .add_option(
          "--preset", o.accuracy.presets,
          "Trackers to compare: paper, paper-all-pixels, accurate, fast; with options changed: "
          "accurate:joint=1")
      ->capture_default_str();
  AddBackendOption(command, o.accuracy.backend);
  command.add_option("--init", o.accuracy.initializer, "Where alignments start, as of silt track")
      ->capture_default_str();
  command
      .add_option("--depth-sensor", o.accuracy.depth_sensor,
                  "Depth: perfect, png16, kinect, kinect-legacy, khoshelham or nguyen")
      ->check(CLI::IsMember(sim::DepthSensorModels()))
      ->capture_default_str();
  RequireInteger(command.add_option("--threads", o.threads, "Threads; 0: one per processor")
                     ->capture_default_str(),
                 0, 1024);
}

}  // namespace

void AddAccuracyExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  options->accuracy.width = 0;
  CLI::App* command = experiments.add_subcommand(
      "accuracy", "The paper's Tables 2 and 3 and Figs. 5 and 6: 20fps, 60fps, 60fps-blur");
  AddOptions(*command, *options);
  command->footer(
      "Every frame is rendered once and tracked in memory. The folder gets accuracy.json,\n"
      "accuracy.csv, trajectories, errors per frame, figures and report.html; trajectories are\n"
      "the same bytes in every run and for any number of threads.\n"
      "Example: silt experiment accuracy --full --seeds 5 --out results/accuracy-full");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
