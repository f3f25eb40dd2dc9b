// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/track_bench.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

struct Options {
  TrackBenchOptions bench;
  PairChoice choice;
  std::string scene = "office", trajectory, pairs, truth, json;
  std::vector<std::string> folders;
  std::vector<double> camera;
  double fps = 30, depth_per_metre = 5000;
  int width = 640;
};

bool Rendered(const Options& options) { return options.folders.empty() && options.pairs.empty(); }

PinholeCamera Camera(const Options& options) {
  const std::vector<double>& k = options.camera;
  if (k.empty()) return {};
  for (const double value : k) {
    if (!std::isfinite(value)) throw Error("--camera: fx fy cx cy must be finite");
  }
  if (k[0] <= 0 || k[1] == 0) throw Error("--camera: fx must be above 0 and fy not 0");
  return {k[0], k[1], k[2], k[3]};
}

std::vector<BenchPair> PairsFromDisk(const Options& options) {
  std::vector<BenchPair> pairs;
  if (!options.pairs.empty()) {
    if (options.truth.empty() || options.camera.empty()) {
      throw Error("--pairs: give --truth and --camera too");
    }
    pairs =
        ListedBenchPairs(options.pairs, options.truth, Camera(options), options.depth_per_metre);
  }
  for (const std::string& folder : options.folders) {
    for (BenchPair& pair :
         FolderBenchPairs(folder, Camera(options), options.depth_per_metre, options.choice)) {
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

// The pairs, and in `source` where they are from.
std::vector<BenchPair> Pairs(const Options& options, Json* source) {
  if (!Rendered(options)) {
    *source = {{"folders", options.folders},
               {"pairs", options.pairs},
               {"truth", options.truth},
               {"camera", options.camera},
               {"depth_per_metre", options.depth_per_metre}};
    return PairsFromDisk(options);
  }
  const World world = LoadWorld(options.scene, options.trajectory);
  RenderPlan plan{PaperRenderOptions(false), false, {options.fps, 0, 0}, {}};
  plan.options.camera = IclNuimCameraOfWidth(options.width);
  *source = {{"world", world.ToJson()}, {"render", plan.ToJson()}};
  return RenderBenchPairs(world, plan.options, options.fps, options.choice);
}

void Run(const Options& options, const Invocation& invocation) {
  Json source;
  std::vector<BenchPair> pairs = Pairs(options, &source);
  const TrackBench bench = MeasureTracking(std::move(pairs), options.bench);
  Json json = bench.ToJson();
  source["instants"] = options.choice.instants;
  source["gaps"] = options.choice.gaps;
  const Json config{{"source", source}, {"bench", options.bench.ToJson()}};
  json["manifest"] = MakeManifest(invocation.command_line, config, 0);
  if (!options.json.empty()) WriteJson(options.json, json);
  if (options.json != "-") Print(bench.Format());
}

void AddSources(CLI::App& command, Options& o) {
  command.add_option("--scene", o.scene, "Scene by name or path")->capture_default_str();
  command.add_option("--trajectory", o.trajectory,
                     "Camera path by name or path; default: desk, or the only one");
  RequireNumber(command.add_option("--fps", o.fps, "Of the rendered frames")->capture_default_str(),
                0.1, 10000);
  RequireInteger(
      command.add_option("--width", o.width, "Of rendered frames")->capture_default_str(), 64,
      8192);
  command.add_option("--folder", o.folders,
                     "Instead of rendering: folders in TUM's layout with groundtruth.txt");
  command.add_option("--pairs", o.pairs,
                     "Instead, too: list of pairs, ref_rgb ref_depth cur_rgb cur_depth");
  command.add_option("--truth", o.truth,
                     "With --pairs: true poses; files are named by their times");
  command
      .add_option("--camera", o.camera,
                  "fx fy cx cy of the frames on disk; fy < 0: poses in ICL-NUIM's axes")
      ->expected(4);
  RequireNumber(command.add_option("--depth-scale", o.depth_per_metre, "Steps of depth per metre")
                    ->capture_default_str(),
                1e-3, 1e9);
}

}  // namespace

void AddTrackBench(CLI::App& bench, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand(
      "track", "How fast and how well pairs of frames are aligned, beside OpenCV's odometries");
  AddSources(*command, *options);
  RequireInteger(command->add_option("--gaps", options->choice.gaps, "Frames that pairs are apart")
                     ->capture_default_str(),
                 1, 100000);
  const auto integer = [&](const char* name, int& value, int high, const char* help) {
    RequireInteger(command->add_option(name, value, help)->capture_default_str(), 1, high);
  };
  integer("--instants", options->choice.instants, 10000, "Pairs of each gap, evenly spread");
  integer("--repeats", options->bench.repeats, 1000, "Of which the fastest counts");
  integer("--threads", options->bench.threads, 1024, "Threads; one thread is measured beside them");
  AddBackendOption(*command, options->bench.backend);
  command
      ->add_option("--preset", options->bench.presets,
                   "Presets to compare; name:option=value changes one")
      ->capture_default_str();
  command->add_option("--json", options->json, "File for the results; -: stdout");
  command->footer(
      "Times are from two colour images with depth in memory to the pose: gray images, pyramids\n"
      "and all else that a method prepares included. All start from the identity. OpenCV's are\n"
      "cv::rgbd::RgbdOdometry and RgbdICPOdometry with their defaults. A frame's stages are those\n"
      "against a keyframe that is there already; what making it took is the stage keyframe.\n"
      "These are the host's times, transfers to and from a GPU included. The refinement alone, of\n"
      "images that lie ready, is timed by the device's own clock where it has one, pair after "
      "pair,\n"
      "beside what must be read and computed at least (dense/work_floor.h) and what the device\n"
      "reaches in kernels that only copy or only multiply and add.\n"
      "Examples: silt bench track --json track.json\n"
      "          silt bench track --folder office --camera 481.2 -480 319.5 239.5 --gaps 1 9");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
