// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/consistency_run.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/progress.h"

namespace silt::experiments {
namespace {

struct Options {
  ConsistencyPlan plan;
  std::string scene = "office", trajectory, json;
  int threads = 0;
};

void Run(const Options& options, const Invocation& invocation) {
  SetThreadCount(options.threads);
  const World world = LoadWorld(options.scene, options.trajectory);
  Progress progress(double(ConsistencyCases().size()));
  std::vector<ConsistencyResult> results;
  for (const ConsistencyCase& each : ConsistencyCases()) {
    results.push_back(MeasureConsistency(world, options.plan, each));
    progress.Advance(1, each.name);
  }
  const DepthConsistency depth = MeasureDepthConsistency(world, options.plan);
  if (!options.json.empty()) {
    const Json config{{"world", world.ToJson()}, {"plan", options.plan.ToJson()}};
    WriteJson(options.json, {{"pictures", ToJson(results)},
                             {"depth", depth.ToJson()},
                             {"manifest", MakeManifest(invocation.command_line, config, 0)}});
  }
  if (options.json != "-") Print(FormatConsistency(results, depth));
}

}  // namespace

void AddPhotoConsistencyExperiment(CLI::App& experiments, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = experiments.add_subcommand(
      "photo-consistency", "How well frames agree when the truth warps one onto another");
  command->add_option("--scene", options->scene, "Scene by name or path")->capture_default_str();
  command->add_option("--trajectory", options->trajectory,
                      "Camera path by name or path; default: desk, or the only one");
  const auto integer = [&](const char* name, int& value, int low, int high, const char* help) {
    RequireInteger(command->add_option(name, value, help)->capture_default_str(), low, high);
  };
  integer("--width", options->plan.width, 16, 8192, "Width of the image; its height is 3/4 of it");
  integer("--pairs", options->plan.pairs, 1, 1000, "Pairs of frames, evenly spread over the path");
  integer("--apart", options->plan.apart, 1, 1000, "Frames from one of a pair to the other");
  integer("--threads", options->threads, 0, 1024, "Threads; 0: one per processor");
  RequireNumber(
      command->add_option("--fps", options->plan.fps, "Frames per second")->capture_default_str(),
      0.1, 10000);
  command->add_option("--json", options->json, "File for the results; -: stdout");
  command->footer(
      "Noise-free frame k + 10 is warped onto frame k by depth, poses and intrinsics, outside\n"
      "occlusions; differences are medians of luma in levels of 255. Where the gradient is 0.5 to\n"
      "2 levels per pixel they show aliasing, elsewhere there is little to differ. The first two\n"
      "rows, of many samples under the Gaussian filter, alias least. Depths are\n"
      "compared with the exact ray of the other frame where it meets the same triangle.\n"
      "Example: silt experiment photo-consistency --json consistency.json");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
