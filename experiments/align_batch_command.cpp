// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/formatted.h"
#include "silt/core/parallel.h"
#include "silt/dense/align_bench.h"
#include "silt/dense/align_figures.h"
#include "silt/experiments/bench_pairs.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/tracker_options.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string scene = "office", trajectory, backend = "cpu", preset, json;
  int pairs = 32, width = 640, starts = 100, threads = 0;
  double fps = 30;
};

std::vector<dense::MovedPair> RenderPairs(const Options& options, const World& world) {
  sim::RenderOptions rendering = PaperRenderOptions(false);
  rendering.camera = IclNuimCameraOfWidth(options.width);
  std::vector<dense::MovedPair> pairs;
  for (BenchPair& pair : RenderBenchPairs(world, rendering, options.fps, {options.pairs, {1}})) {
    FramePair& frames = pair.frames;
    pairs.push_back({frames.camera, std::move(frames.reference), std::move(frames.current),
                     frames.current_from_reference});
  }
  return pairs;
}

tracker::AlignmentOptions Alignment(const std::string& preset) {
  return preset.empty() ? dense::RefinementOptions() : PresetOptions(preset).alignment;
}

void Run(const Options& options, const Invocation& invocation) {
  SetThreadCount(options.threads);
  const auto backend = MakeBackend(options.backend);
  const tracker::AlignmentOptions alignment = Alignment(options.preset);
  const World world = LoadWorld(options.scene, options.trajectory);
  const dense::AlignFigures figures =
      dense::MeasureBatch(*backend, RenderPairs(options, world), alignment, options.starts);
  const Json config{{"world", world.ToJson()},
                    {"backend", backend->name()},
                    {"alignment", options.preset.empty() ? "20/20/5/2" : options.preset},
                    {"pairs", options.pairs},
                    {"width", options.width},
                    {"starts", options.starts},
                    {"fps", options.fps}};
  const dense::Ceilings ceilings = dense::MeasureCeilings(backend->name());
  Json json{{"batch", Json::parse(dense::FiguresJson(figures, ceilings).Text())},
            {"device", Json::parse(dense::DeviceFacts(backend->name(), ceilings).Text())},
            {"manifest", MakeManifest(invocation.command_line, config, 0)}};
  if (!options.json.empty()) WriteJson(options.json, json);
  if (options.json == "-") return;
  Print(Formatted("%d alignments at once on %s, of %d pairs; for each:\n", figures.alignments,
                  backend->name().c_str(), options.pairs) +
        dense::FiguresText("batch", figures, ceilings));
}

}  // namespace

void AddAlignBatchBench(CLI::App& bench, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = bench.add_subcommand(
      "align-batch", "How many alignments a second a backend does, many at once");
  command->add_option("--scene", options->scene, "Scene by name or path")->capture_default_str();
  command->add_option("--trajectory", options->trajectory,
                      "Camera path by name or path; default: desk, or the only one");
  AddBackendOption(*command, options->backend);
  command->add_option("--preset", options->preset,
                      "Whose refinement; default: the paper's 20/20/5/2 solves, none saved");
  const auto integer = [&](const char* name, int& value, int low, int high, const char* help) {
    RequireInteger(command->add_option(name, value, help)->capture_default_str(), low, high);
  };
  integer("--pairs", options->pairs, 1, 1000, "Pairs of neighbouring frames, evenly spread");
  integer("--starts", options->starts, 1, 1000000, "Starts, over all pairs");
  integer("--width", options->width, 64, 8192, "Of the frames");
  integer("--threads", options->threads, 0, 1024, "Of the CPU; 0: one per processor");
  RequireNumber(command->add_option("--fps", options->fps, "Of the frames")->capture_default_str(),
                0.1, 10000);
  command->add_option("--json", options->json, "File for the results; -: stdout");
  command->footer(
      "Starts lie up to 2 cm and 1 deg from the truth and are dealt out to the pairs in turn: of "
      "32\n"
      "pairs, the images do not fit into the caches of a large GPU. The whole batch is run once\n"
      "before it is measured. Times are the device's own where it has a clock. A floor is what "
      "must\n"
      "be read and computed at least (dense/work_floor.h); beside it stands what the device "
      "reaches\n"
      "in kernels that only copy or only multiply and add.\n"
      "Example: silt bench align-batch --backend cuda --starts 20000 --json batch.json");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
