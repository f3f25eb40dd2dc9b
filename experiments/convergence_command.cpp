// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/atomic_file.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/convergence_report.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/experiment_basics.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/experiments/progress.h"
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
};

struct Series {
  std::string name;
  std::vector<PoseDifference> offsets;
};

std::vector<Series> AllSeries(bool quick) {
  if (quick) return {{"distance and angle", {{0.01, 0.5}, {0.04, 2}, {0.16, 8}}}};
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
  return o;
}

// The first starts at the chosen image, the paper's being 1; the others at equal distances along
// the path.
std::vector<PairAlignment> MakePairs(const Options& options, const World& world,
                                     const tracker::Backend& backend) {
  std::vector<PairAlignment> pairs;
  const double step_s = (world.path.duration_s() - kPairGap_s) / options.pairs;
  for (int i = 0; i < options.pairs; ++i) {
    ThrowIfInterrupted();
    const double start_s = i == 0 ? (options.image - 1) / kFps : i * step_s;
    const FramePair pair =
        RenderPair(world, options.basics.Rendering(false), start_s, start_s + kPairGap_s);
    pairs.emplace_back(backend, pair, PyramidScheme().levels());
  }
  return pairs;
}

std::vector<NamedSuccessRate> MeasureAll(const Options& options,
                                         const std::vector<PairAlignment>& pairs) {
  const std::vector<Series> all = AllSeries(options.basics.quick);
  double total = 0;
  for (const Series& series : all) total += double(series.offsets.size());
  Progress progress(total);
  std::vector<NamedSuccessRate> rates;
  for (const Series& series : all) {
    for (const PoseDifference& offset : series.offsets) {
      ThrowIfInterrupted();
      RandomStarts starts{offset, options.starts, options.basics.seed};
      rates.push_back({kPyramid, series.name, MeasureSuccessRate(pairs, starts, PyramidScheme())});
      starts.count = std::max(1, options.starts / kFullResolutionShare);
      rates.push_back({kFullResolution, series.name,
                       MeasureSuccessRate(pairs, starts, FullResolutionScheme())});
      progress.Advance(1, "random starts, " + series.name);
    }
  }
  return rates;
}

void Run(const Options& given, const Invocation& invocation) {
  const Options options = Resolved(given);
  SetThreadCount(options.basics.threads);
  OutputFolder folder(options.basics.out);
  const World world = options.basics.Load();
  const auto backend = MakeBackend(options.basics.backend);
  const std::vector<PairAlignment> pairs = MakePairs(options, world, *backend);
  const std::vector<ConvergenceRun> runs = RunPaperConvergence(pairs.front());
  const std::vector<NamedSuccessRate> rates = MeasureAll(options, pairs);

  const Json config{{"basics", options.basics.ToJson()}, {"world", world.ToJson()},
                    {"reference_image", options.image},  {"pairs", options.pairs},
                    {"starts_per_pair", options.starts}, {"pair_gap_s", kPairGap_s}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.basics.seed);
  const Json json{{"manifest", manifest},
                  {"true_motion", ToJson(Difference(pairs.front().truth(), SE3d{}))},
                  {"levels", LevelRows(runs)},
                  {"iterations", IterationRows(runs)},
                  {"success_rates", SuccessRows(rates)}};
  WriteJson(folder.path() / "convergence.json", json);
  for (const char* table : {"levels", "iterations", "success_rates"}) {
    WriteFileAtomically(folder.path() / (std::string(table) + ".csv"), FormatCsv(json[table]));
  }
  DrawFigures("convergence.py", folder.path());
  folder.Commit(manifest);
  Print(FormatConvergence(runs, rates) + "Results: " + options.basics.out + "\n");
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
  command->footer(
      "Images 1 and 10 at 20 fps are aligned from [R_true, 0.6 t_true], with the four-level\n"
      "pyramid and with the full resolution only; then from random starts around the truth.\n"
      "Example: silt experiment convergence --out results/convergence");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
