// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/csv.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/pair_rendering.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/tracker_options.h"
#include "silt/experiments/trust_calibration.h"

namespace silt::experiments {
namespace {

struct Options {
  ExperimentBasics basics;
  int pairs = 0;
  std::vector<std::string> presets = {"paper", "accurate", "fast"};
  std::vector<std::string> images = {"sharp", "noisy", "blurred"};
};

struct ImageKind {
  std::string name;
  sim::RenderOptions rendering;
};

// In 8 bits: without noise, with Handa's, and with it through the paper's open shutter.
std::vector<ImageKind> ImageKinds(const ExperimentBasics& basics) {
  sim::RenderOptions sharp = basics.Rendering(false), blurred = basics.Rendering(true);
  sim::RenderOptions noisy = sharp;
  noisy.sensor = blurred.sensor;
  return {{"sharp", sharp}, {"noisy", noisy}, {"blurred", blurred}};
}

std::vector<TrustSample> Measure(const Options& options, const World& world) {
  const ExperimentBasics& basics = options.basics;
  const std::vector<TrustPair> pairs =
      TrustPairs(world.path.duration_s(), options.pairs, basics.seed);
  std::vector<ImageKind> kinds = ImageKinds(basics);
  std::erase_if(kinds, [&](const ImageKind& kind) {
    return std::find(options.images.begin(), options.images.end(), kind.name) ==
           options.images.end();
  });
  Progress progress(double(kinds.size() * pairs.size()));
  std::vector<TrustSample> samples;
  for (const ImageKind& kind : kinds) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const TrustPair& pair = pairs[i];
      sim::RenderOptions rendering = kind.rendering;
      rendering.seed = basics.seed * pairs.size() + i;  // noise that no other pair has
      const FramePair frames = RenderPair(world, rendering, pair.reference_s, pair.current_s);
      for (const std::string& preset : options.presets) {
        TrustSample sample = MeasureTrust(frames, {preset, basics.backend, "sparse", basics.seed});
        sample.images = kind.name;
        sample.pair = pair;
        samples.push_back(std::move(sample));
      }
      progress.Advance(1, kind.name);
    }
  }
  return samples;
}

void Run(const Options& given, const Invocation& invocation) {
  Options options = given;
  options.basics = given.basics.Resolved();
  if (options.pairs == 0) options.pairs = options.basics.quick ? 4 : 60;
  SetThreadCount(options.basics.threads);
  for (const std::string& preset : options.presets) PresetOptions(preset);
  OutputFolder folder(options.basics.out);
  const World world = options.basics.Load();
  const std::vector<TrustSample> samples = Measure(options, world);
  const std::vector<TrustSummary> summaries = SummarizeTrust(samples);

  const Json config{{"basics", options.basics.ToJson()},
                    {"pairs", options.pairs},
                    {"presets", options.presets},
                    {"images", options.images},
                    {"world", world.ToJson()}};
  const Json manifest = MakeManifest(invocation.command_line, config, options.basics.seed);
  Json summary_rows = Json::array(), sample_rows = Json::array();
  for (const TrustSummary& summary : summaries) summary_rows.push_back(summary.ToJson());
  for (const TrustSample& sample : samples) sample_rows.push_back(sample.ToJson());
  const Json json{{"manifest", manifest}, {"summary", summary_rows}, {"samples", sample_rows}};
  WriteJson(folder.path() / "trust.json", json);
  for (const char* table : {"summary", "samples"}) {
    WriteFileAtomically(folder.path() / (std::string(table) + ".csv"), FormatCsv(json[table]));
  }
  folder.Commit(manifest);
  Print(FormatTrust(summaries) + "Results: " + options.basics.out + "\n");
}

}  // namespace

void AddTrustExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "trust", "Whether covariances and statuses of poses say how wrong they are");
  AddExperimentBasics(*command, options->basics);
  RequireInteger(
      command->add_option("--pairs", options->pairs, "Pairs of frames of each kind; default: 60"),
      1, 100000);
  command->add_option("--preset", options->presets, "Trackers to compare")->capture_default_str();
  command
      ->add_option("--images", options->images,
                   "Kinds of images: sharp, noisy (Handa's), blurred (and noisy)")
      ->check(CLI::IsMember({"sharp", "noisy", "blurred"}))
      ->capture_default_str();
  command->footer(
      "Pairs of frames are spread over the path; a tracker whose only keyframe is the first says\n"
      "where the second is: of frames up to 0.5 s apart, and of any two (jumps). NEES is\n"
      "the error squared in units of its covariance; the mean of n right ones lies around 6, in\n"
      "the band in 99 of 100 cases. factor: by which covariances have to be multiplied to be\n"
      "right. wild: farther off than 5 cm or 2 degrees.\n"
      "Example: silt experiment trust --pairs 100 --out results/trust");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
