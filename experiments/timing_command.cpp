// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/io/tum_sequence.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/timing.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

constexpr int kCalls = 21;  // of warp and Jacobian each

struct Options {
  ExperimentBasics basics;
  double fps = 20, duration_s = 0;
};

Options Resolved(const Options& options) {
  Options o = options;
  o.basics = options.basics.Resolved();
  if (o.duration_s == 0) o.duration_s = o.basics.quick ? 0.5 : 3;
  return o;
}

// Renders the stretch into files, so that loading them can be timed.
void WriteSequence(const World& world, const RenderPlan& plan, const std::filesystem::path& to) {
  const Trajectory truth = TruePoses(world, plan.stretch);
  TumSequenceWriter writer(to, {plan.options.camera, truth, {}});
  Progress progress(double(truth.size()));
  ForEachFrame(world, plan, [&](const RenderedFrame& rendered) {
    writer.Write(rendered.number, rendered.frame);
    progress.Advance(1, "rendering");
  });
  writer.Finish();
}

void Run(const Options& given, const Invocation& invocation) {
  const Options options = Resolved(given);
  SetThreadCount(options.basics.threads);
  OutputFolder folder(options.basics.out);
  const World world = options.basics.Load();
  RenderPlan plan;
  plan.options = options.basics.Rendering(false);
  plan.stretch = {options.fps, 0, options.duration_s};
  const std::filesystem::path frames = folder.path() / "frames";
  WriteSequence(world, plan, frames);

  TumSequence sequence(frames);
  const TrackerSetup setup{"paper", options.basics.backend, "auto", options.basics.seed};
  tracker::KeyframeTracker tracker =
      MakeTracker(sequence.camera(), setup, world.path.WorldFromCamera(0));
  const std::vector<FrameTiming> timings = TimeFrames(sequence, tracker);
  const auto backend = MakeBackend(options.basics.backend);
  const FramePair pair = RenderPair(world, plan.options, 0, 1 / options.fps);
  const std::vector<StageTiming> stages =
      SummarizeTiming(timings, TimeFullSizeCalls(*backend, pair, kCalls));
  std::filesystem::remove_all(frames);  // tens of megabytes that `silt render` makes at any time

  const Json config{{"basics", options.basics.ToJson()},
                    {"world", world.ToJson()},
                    {"render", plan.ToJson()},
                    {"tracker", ToJson(setup)}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.basics.seed);
  const Json json{
      {"manifest", manifest}, {"stages", StageRows(stages)}, {"frames", FrameRows(timings)}};
  WriteJson(folder.path() / "timing.json", json);
  for (const char* table : {"stages", "frames"}) {
    WriteFileAtomically(folder.path() / (std::string(table) + ".csv"), FormatCsv(json[table]));
  }
  DrawFigures("timing.py", folder.path());
  folder.Commit(manifest);
  Print(FormatTiming(stages) + "Results: " + options.basics.out + "\n");
}

}  // namespace

void AddTimingExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "timing", "How long each stage of the tracker takes, beside the paper's section 4.1");
  AddExperimentBasics(*command, options->basics);
  RequireNumber(command->add_option("--fps", options->fps, "Frames per second of the sequence")
                    ->capture_default_str(),
                0.1, 10000);
  RequireNumber(command->add_option("--duration", options->duration_s,
                                    "Seconds of the path from its start; default: 3"),
                0.01, 1e6);
  command->footer(
      "Frames are rendered into files, loaded from there and tracked by the preset paper; medians\n"
      "over all frames but the first. The paper's computer: a Core i7 of 2.2 GHz and a GeForce\n"
      "GT 755M, from 2016.\n"
      "Example: silt experiment timing --out results/timing");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
