// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/initialization_report.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/tracker_options.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

struct Options {
  ExperimentBasics basics;
  double fps = 20;
  int keyframes = 0;
  std::vector<int> gaps;
};

struct Condition {
  std::string name;
  sim::RenderOptions rendering;
};

std::vector<Condition> Conditions(const ExperimentBasics& basics) {
  Condition sharp{"sharp", basics.Rendering(false)}, blurred{"blurred", basics.Rendering(true)};
  Condition noisy{"noisy", blurred.rendering};
  noisy.rendering.shutter.exposure_s = 0;
  return {sharp, noisy, blurred};
}

Options Resolved(const Options& options) {
  Options o = options;
  o.basics = options.basics.Resolved();
  if (o.keyframes == 0) o.keyframes = o.basics.quick ? 2 : 6;
  if (o.gaps.empty()) o.gaps = {1, 2, 4, 7, 10, 15, 20, 30, 40};
  if (o.basics.quick && options.gaps.empty()) o.gaps = {1, 10, 40};
  std::sort(o.gaps.begin(), o.gaps.end());
  return o;
}

// Numbers of the frames that serve as keyframes, at equal distances along the path.
std::vector<int> KeyframeNumbers(const Options& options, const World& world) {
  const int last = int(std::floor(world.path.duration_s() * options.fps)) - options.gaps.back() - 1;
  if (last < 0) {
    throw Error(world.path_file.string() + ": is too short for a gap of " +
                std::to_string(options.gaps.back()) + " frames; lower --gaps or raise --fps");
  }
  std::vector<int> numbers;
  for (int i = 0; i < options.keyframes; ++i) {
    numbers.push_back(int(double(last) * i / std::max(1, options.keyframes - 1)));
  }
  return numbers;
}

// All conditions, keyframes and gaps.
class Experiment {
 public:
  Experiment(const Options& options, const World& world)
      : options_(options),
        world_(world),
        backend_(MakeBackend(options.basics.backend)),
        refinement_(PresetOptions("paper").alignment) {}

  std::vector<InitializationRecord> Run() {
    const std::vector<int> keyframes = KeyframeNumbers(options_, world_);
    const std::vector<Condition> conditions = Conditions(options_.basics);
    Progress progress(double(conditions.size() * keyframes.size() * options_.gaps.size()));
    std::vector<InitializationRecord> records;
    for (const Condition& condition : conditions) {
      for (const int number : keyframes) RunKeyframe(condition, number, &progress, &records);
    }
    return records;
  }

 private:
  double Time(int number) const { return number / options_.fps; }
  SE3d WorldFromCamera(int number) const { return world_.path.WorldFromCamera(Time(number)); }

  void RunKeyframe(const Condition& condition, int number, Progress* progress,
                   std::vector<InitializationRecord>* records) {
    tracker::Keyframe keyframe;
    keyframe.id = next_id_++;
    keyframe.frame = RenderAt(world_, condition.rendering, Time(number));
    keyframe.intensity = GrayFromRgb(keyframe.frame.rgb);
    const Initializers initializers = MakeInitializers();
    for (const int gap : options_.gaps) {
      ThrowIfInterrupted();
      const Frame current = RenderAt(world_, condition.rendering, Time(number + gap));
      const SE3d world_from_keyframe = WorldFromCamera(number);
      const InitializationCase each{
          keyframe, current, condition.rendering.camera,
          WorldFromCamera(number + gap).Inverse() * world_from_keyframe,
          WorldFromCamera(number + gap - 1).Inverse() * world_from_keyframe,
          // Before the path begins the camera rests.
          WorldFromCamera(std::max(0, number + gap - 2)).Inverse() * world_from_keyframe,
          number + gap, options_.basics.seed};
      records->push_back({condition.name, gap, Time(number),
                          TryStarts(each, *backend_, initializers, refinement_)});
      progress->Advance(1, condition.name + ", " + std::to_string(gap) + " frames apart");
    }
  }

  const Options& options_;
  const World& world_;
  std::unique_ptr<const tracker::Backend> backend_;
  tracker::AlignmentOptions refinement_;
  int next_id_ = 0;
};

void Run(const Options& given, const Invocation& invocation) {
  const Options options = Resolved(given);
  SetThreadCount(options.basics.threads);
  OutputFolder folder(options.basics.out);
  const World world = options.basics.Load();
  const std::vector<InitializationRecord> records = Experiment(options, world).Run();

  const Json config{{"basics", options.basics.ToJson()},
                    {"world", world.ToJson()},
                    {"fps", options.fps},
                    {"keyframes", options.keyframes},
                    {"gaps", options.gaps},
                    {"success", ToJson(kInitialized)}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.basics.seed);
  const Json json{
      {"manifest", manifest}, {"summary", SummaryRows(records)}, {"cases", CaseRows(records)}};
  WriteJson(folder.path() / "initialization.json", json);
  for (const char* table : {"summary", "cases"}) {
    WriteFileAtomically(folder.path() / (std::string(table) + ".csv"), FormatCsv(json[table]));
  }
  DrawFigures("initialization.py", folder.path());
  folder.Commit(manifest);
  Print(FormatInitialization(json["summary"]) + "Results: " + options.basics.out + "\n");
}

}  // namespace

void AddInitializationExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "initialization", "Every kind of start (--init of silt track), over frame gaps");
  AddExperimentBasics(*command, options->basics);
  RequireNumber(command->add_option("--fps", options->fps, "Frames per second, the unit of gaps")
                    ->capture_default_str(),
                0.1, 10000);
  RequireInteger(
      command->add_option("--keyframes", options->keyframes, "Keyframes per condition; default: 6"),
      1, 10000);
  RequireInteger(command->add_option("--gaps", options->gaps,
                                     "Frames from keyframe to frame; default: 1 2 4 7 10 15 20 "
                                     "30 40"),
                 1, 100000);
  command->footer(
      "Each start is refined by the preset paper; it was good if that ends within 1 cm and 0.5 "
      "deg\n"
      "of the truth. Conditions: sharp; noisy (Handa's noise); blurred (noise, and a shutter open\n"
      "for 1/60 s). Previous poses are the true ones: those of a tracker without an error so far.\n"
      "Example: silt experiment initialization --out results/initialization");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
