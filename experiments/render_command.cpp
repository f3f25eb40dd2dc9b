// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/io/tum_sequence.h"
#include "silt/core/parallel.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/manifest.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/output_folder.h"
#include "silt/experiments/path_facts.h"
#include "silt/experiments/progress.h"
#include "silt/experiments/simulation_options.h"

namespace silt::experiments {
namespace {

struct Options {
  SimulationOptions simulation;
  std::string out;
  bool allow_crossing = false;
};

void Run(const Options& options, const Invocation& invocation) {
  SetThreadCount(options.simulation.threads);
  const RenderPlan plan = options.simulation.Plan();
  OutputFolder folder(options.out);
  const World world = LoadWorld(options.simulation.scene, options.simulation.trajectory,
                                options.simulation.Lighting());
  const int frames = int(TruePoses(world, plan.stretch).size());
  if (!options.allow_crossing) RequireNoCrossing(world, plan.stretch);
  {
    Progress progress(frames);
    TumSequenceWriter writer(folder.path(), plan.options.camera);
    ForEachFrame(world, plan, [&](const RenderedFrame& rendered) {
      writer.Write(rendered.frame, rendered.truth.world_from_camera);
      progress.Advance(
          1, "frame " + std::to_string(rendered.number + 1) + " of " + std::to_string(frames));
    });
    writer.Finish();
  }
  const Json config{{"world", world.ToJson()}, {"render", plan.ToJson()}};
  folder.Commit(MakeManifest(invocation.command_line, config, plan.options.seed));
  Print(std::to_string(frames) + " frames in " + options.out + "\n");
}

}  // namespace

void AddRenderCommand(CLI::App& program, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "render", "Render a sequence along a camera path into a folder in TUM's layout");
  AddSimulationOptions(*command, options->simulation, true);
  command->add_option("--out", options->out, "Folder to make; refused where others' files lie")
      ->required();
  command->add_flag("--allow-crossing", options->allow_crossing,
                    "Render also where the camera passes through surfaces of the scene");
  command->footer(
      "The folder holds rgb/ depth/ (16 bit, 5000 per metre, along the optical axis), rgb.txt\n"
      "depth.txt associations.txt groundtruth.txt camera.txt and manifest.json. The pictures are\n"
      "the same for any number of threads.\n"
      "Example: silt render --scene office --trajectory desk --fps 20 --duration 2 --out office20");
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
