// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/convergence_report.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/odometry_trial.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/recovery.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

// The paper's images 1 and 10 of 20 per second.
constexpr double kFps = 20, kPairGap_s = 9 / kFps;
// Without the pyramid an alignment takes twenty times as long, and so gets a fourth of the starts.
constexpr int kFullResolutionShare = 4;

struct Options {
  ExperimentBasics basics;
  int image = 1, pairs = 0, starts = 0;
  std::vector<std::string> offsets;  // "4:2", cm and degrees; none: all series
  std::string scheme = "both";
  int recovery_pairs = 0, trials = -1;
  RecoveryOptions recovery{{}, -1, -1, 0};  // nothing chosen
};

struct Series {
  std::string name;
  std::vector<PoseDifference> offsets;
};

// "4:2" is 4 cm and 2°.
PoseDifference OffsetOf(const std::string& text) {
  const std::size_t colon = text.find(':');
  double cm = 0, degrees = 0;
  if (colon == text.npos || !CLI::detail::lexical_cast(text.substr(0, colon), cm) ||
      !CLI::detail::lexical_cast(text.substr(colon + 1), degrees) || !(cm >= 0 && cm <= 1e4) ||
      !(degrees >= 0 && degrees <= 180)) {
    throw Error("--offset: '" + text +
                "' is not CM:DEG, a distance in cm and an angle up to 180 degrees, as 4:2");
  }
  return {cm / 100, degrees};
}

bool Has(const Options& options, const char* scheme) {
  return options.scheme == "both" || options.scheme == scheme;
}

std::vector<Series> AllSeries(const Options& options) {
  if (!options.offsets.empty()) {
    Series chosen{"chosen", {}};
    for (const std::string& offset : options.offsets) chosen.offsets.push_back(OffsetOf(offset));
    return {chosen};
  }
  if (options.basics.quick) return {{"distance and angle", {{0.01, 0.5}, {0.04, 2}, {0.16, 8}}}};
  Series distance{"distance", {}}, angle{"angle", {}}, both{"distance and angle", {}};
  for (const double cm : {0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 12.0, 16.0}) {
    distance.offsets.push_back({cm / 100, 0});
    angle.offsets.push_back({0, cm});  // as many degrees as there are centimetres
    both.offsets.push_back({cm / 100, cm / 2});
  }
  return {distance, angle, both};
}

Options Resolved(const Options& options) {
  Options o = options;
  o.basics = options.basics.Resolved();
  if (o.pairs == 0) o.pairs = o.basics.quick ? 1 : 3;
  if (o.starts == 0) o.starts = o.basics.quick ? 4 : 8;
  if (o.recovery_pairs == 0) o.recovery_pairs = o.basics.quick ? 2 : 10;
  if (o.recovery.presets.empty()) o.recovery.presets = RecoveryOptions().presets;
  if (o.recovery.starts < 0) o.recovery.starts = o.basics.quick ? 4 : 1000;
  if (o.recovery.comparison < 0) o.recovery.comparison = std::min(100, o.recovery.starts / 2);
  if (o.trials < 0) o.trials = o.basics.quick ? 2 : 100;
  o.recovery.seed = o.basics.seed;
  return o;
}

// The first starts at the chosen image, the paper's being 1; the others at equal distances along
// the path.
std::vector<FramePair> RenderPairs(const Options& options, const World& world, int count) {
  std::vector<FramePair> pairs;
  const double step_s = (world.path.duration_s() - kPairGap_s) / count;
  for (int i = 0; i < count; ++i) {
    ThrowIfInterrupted();
    const double start_s = i == 0 ? (options.image - 1) / kFps : i * step_s;
    pairs.push_back(
        RenderPair(world, options.basics.Rendering(false), start_s, start_s + kPairGap_s));
  }
  return pairs;
}

std::vector<PairAlignment> MakePairs(const Options& options, const World& world,
                                     const tracker::Backend& backend) {
  std::vector<PairAlignment> pairs;
  for (const FramePair& pair : RenderPairs(options, world, options.pairs)) {
    pairs.emplace_back(backend, pair, PyramidScheme().levels());
  }
  return pairs;
}

// Of the first reference frame, both warped and rendered anew.
std::vector<OdometryTrial> RunTrials(const Options& options, const World& world) {
  const sim::RenderOptions rendering = options.basics.Rendering(false);
  const sim::Renderer renderer(world.scene, rendering);
  const double time_s = (options.image - 1) / kFps;
  const SE3d world_from_frame = world.path.WorldFromCamera(time_s);
  const auto rendered = [&](const SE3d& current_from_frame) {
    const SE3d pose = world_from_frame * current_from_frame.Inverse();
    return renderer.Render([&](double) { return pose; }, time_s, 0);
  };
  const Frame frame = rendered(SE3d{});
  const auto warped = [&](const SE3d& current_from_frame) {
    return ForwardWarp(frame, rendering.camera, current_from_frame);
  };
  std::vector<OdometryTrial> trials;
  Progress progress(2 * double(options.recovery.presets.size()));
  for (const std::string& preset : options.recovery.presets) {
    for (const auto& [name, moved] : {std::pair<const char*, MovedFrame>{"warped", warped},
                                      std::pair<const char*, MovedFrame>{"rendered", rendered}}) {
      trials.push_back(
          RunTrial(frame, rendering.camera, moved, preset, options.trials, options.basics.seed));
      trials.back().current = name;
      progress.Advance(1, std::string("small motions, ") + name);
    }
  }
  return trials;
}

std::vector<NamedSuccessRate> MeasureAll(const Options& options,
                                         const std::vector<PairAlignment>& pairs) {
  const std::vector<Series> all = AllSeries(options);
  double total = 0;
  for (const Series& series : all) total += double(series.offsets.size());
  Progress progress(total);
  std::vector<NamedSuccessRate> rates;
  for (const Series& series : all) {
    for (const PoseDifference& offset : series.offsets) {
      ThrowIfInterrupted();
      RandomStarts starts{offset, options.starts, options.basics.seed};
      if (Has(options, "pyramid")) {
        rates.push_back(
            {kPyramid, series.name, MeasureSuccessRate(pairs, starts, PyramidScheme())});
      }
      starts.count = std::max(1, options.starts / kFullResolutionShare);
      if (Has(options, "full")) {
        rates.push_back({kFullResolution, series.name,
                         MeasureSuccessRate(pairs, starts, FullResolutionScheme())});
      }
      progress.Advance(1, "random starts, " + series.name);
    }
  }
  return rates;
}

void Run(const Options& given, const Invocation& invocation) {
  const Options options = Resolved(given);
  AllSeries(options);  // or says what is wrong, before anything takes long
  SetThreadCount(options.basics.threads);
  OutputFolder folder(options.basics.out);
  const World world = options.basics.Load();
  const auto backend = MakeBackend(options.basics.backend);
  const std::vector<PairAlignment> pairs = MakePairs(options, world, *backend);
  const std::vector<ConvergenceRun> runs = RunPaperConvergence(pairs.front());
  const std::vector<NamedSuccessRate> rates = MeasureAll(options, pairs);
  std::vector<FramePair> recovery_pairs;
  std::vector<Recovery> recoveries;
  if (options.recovery.starts > 0) {
    recovery_pairs = RenderPairs(options, world, options.recovery_pairs);
    recoveries = MeasureRecovery(recovery_pairs, *backend, options.recovery);
  }
  std::vector<OdometryTrial> trials;
  if (options.trials > 0) trials = RunTrials(options, world);

  const Json config{{"basics", options.basics.ToJson()},
                    {"world", world.ToJson()},
                    {"reference_image", options.image},
                    {"pairs", options.pairs},
                    {"starts_per_pair", options.starts},
                    {"offsets", options.offsets},
                    {"scheme", options.scheme},
                    {"pair_gap_s", kPairGap_s},
                    {"presets", options.recovery.presets},
                    {"recovery_starts", options.recovery.starts},
                    {"comparison_starts", options.recovery.comparison},
                    {"recovery_pairs", options.recovery_pairs},
                    {"trials", options.trials}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.basics.seed);
  const Json json{{"manifest", manifest},
                  {"true_motion", ToJson(Difference(pairs.front().truth(), SE3d{}))},
                  {"levels", LevelRows(runs)},
                  {"iterations", IterationRows(runs)},
                  {"success_rates", SuccessRows(rates)},
                  {"recovery", RecoveryRows(recoveries)},
                  {"recovery_pairs", PairRows(recovery_pairs)},
                  {"odometry_trials", TrialRows(trials)}};
  WriteJson(folder.path() / "convergence.json", json);
  for (const char* table :
       {"levels", "iterations", "success_rates", "recovery", "recovery_pairs", "odometry_trials"}) {
    WriteFileAtomically(folder.path() / (std::string(table) + ".csv"), FormatCsv(json[table]));
  }
  DrawFigures("convergence.py", folder.path());
  folder.Commit(manifest);
  std::string text = FormatConvergence(runs, rates);
  if (!recoveries.empty()) text += "\n" + FormatRecovery(recoveries, recovery_pairs);
  if (!trials.empty()) text += "\n" + FormatTrials(trials);
  Print(text + "Results: " + options.basics.out + "\n");
}

void AddRecoveryOptions(CLI::App& command, Options& o) {
  command.add_option("--preset", o.recovery.presets,
                     "Presets for recovery and odometry trials; default: paper accurate fast");
  RequireInteger(command.add_option("--recovery-starts", o.recovery.starts,
                                    "Random starts of each preset and kind, over all pairs; 0: "
                                    "none; default: 1000"),
                 0, 1000000);
  RequireInteger(command.add_option("--comparison-starts", o.recovery.comparison,
                                    "The same of what they are compared with: no wide start, no "
                                    "pyramid; default: 100"),
                 0, 1000000);
  RequireInteger(command.add_option("--recovery-pairs", o.recovery_pairs,
                                    "Pairs of frames for them; default: 10"),
                 1, 1000);
  RequireInteger(command.add_option("--trials", o.trials,
                                    "Motions in OpenCV's test of odometries; 0: none; default: "
                                    "100"),
                 0, 100000);
}

}  // namespace

void AddConvergenceExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "convergence", "The paper's Table 1 and Fig. 4, and success rates from random starts");
  AddExperimentBasics(*command, options->basics);
  RequireInteger(command
                     ->add_option("--image", options->image,
                                  "The reference image, counted from 1; the current one comes "
                                  "nine later")
                     ->capture_default_str(),
                 1, 1000000);
  RequireInteger(command->add_option("--pairs", options->pairs,
                                     "Pairs of frames for the success rates; default: 3"),
                 1, 1000);
  RequireInteger(command->add_option("--starts", options->starts,
                                     "Random starts per pair and offset; default: 8"),
                 1, 100000);
  command->add_option("--offset", options->offsets,
                      "CM:DEG from the truth for those starts; may be repeated; default: series of "
                      "distances, angles and both");
  command
      ->add_option(
          "--scheme", options->scheme,
          "Of those starts: pyramid, full (full resolution only, a fourth of them) or both")
      ->check(CLI::IsMember({"pyramid", "full", "both"}))
      ->capture_default_str();
  AddRecoveryOptions(*command, *options);
  command->footer(
      "Images 1 and 10 at 20 fps are aligned from [R_true, 0.6 t_true], with the four-level\n"
      "pyramid and with the full resolution only; then from random starts around the truth. Then\n"
      "each preset's refinement alone, from up to and from exactly 10 cm and 5 deg, and 20 cm and\n"
      "10 deg, beside the truth; and OpenCV's test of its odometries.\n"
      "Examples: silt experiment convergence --out results/convergence\n"
      "          100,000 starts at one offset, and nothing else of what takes long:\n"
      "          silt experiment convergence --backend cuda --starts 100000 --offset 4:2\n"
      "            --scheme pyramid --pairs 1 --recovery-starts 0 --trials 0 --out basin");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
