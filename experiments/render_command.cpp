// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/folder_ownership.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/path_facts.h"
#include "silt/experiments/render_run.h"
#include "silt/experiments/simulation_options.h"

namespace silt::experiments {
namespace {

const std::vector<std::string> kTruths{"sharp", "depth", "normals", "ids",
                                       "flow",  "imu",   "poses",   "all"};

struct Options {
  SimulationOptions simulation;
  std::vector<std::string> truth;
  std::string imu_noise = "none";
  bool allow_crossing = false;
  RenderRequest request;
};

TruthSelection SelectionOf(const Options& options) {
  const auto asked = [&](const char* name) {
    const auto named = [&](const std::string& word) { return word == name || word == "all"; };
    return std::any_of(options.truth.begin(), options.truth.end(), named);
  };
  TruthSelection selection = options.request.truth;
  selection.sharp = asked("sharp");
  selection.depth = asked("depth");
  selection.normals = asked("normals");
  selection.ids = asked("ids");
  selection.flow = asked("flow");
  selection.imu = asked("imu");
  selection.poses = asked("poses");
  return selection;
}

void Run(const Options& options, const Invocation& invocation) {
  SetThreadCount(options.simulation.threads);
  RenderRequest request = options.request;
  request.plan = options.simulation.Plan();
  request.truth = SelectionOf(options);
  if (options.imu_noise == "euroc") request.imu.noise = ImuNoise::Euroc();
  request.imu.seed = options.simulation.seed;
  RequireOwn(NormalPlace(request.out));  // before the scene's light is computed
  const SimulationOptions& simulation = options.simulation;
  const World world = LoadWorld(simulation.scene, simulation.trajectory, simulation.Lighting());
  TruePoses(world, request.plan.stretch);  // throws where the stretch leaves the path
  if (!options.allow_crossing) RequireNoCrossing(world, request.plan.stretch);
  request.plan = WithExposure(world, request.plan);
  RunRender(world, request, invocation.command_line);
}

void AddOutputOptions(CLI::App& command, RenderRequest& request) {
  const auto group = [](CLI::Option* option) { return option->group("Output"); };
  group(command.add_option("--out", request.out,
                           "Folder to fill; an interrupted render of the same is continued there"))
      ->required();
  group(command.add_option("--format", request.format,
                           "Layout: tum, icl, euroc, nerfstudio, colmap or raw"))
      ->check(CLI::IsMember(SequenceFormats()))
      ->capture_default_str();
  group(command.add_flag("--overwrite", request.overwrite,
                         "Begin anew where another render of silt's lies"));
}

void AddTruthOptions(CLI::App& command, Options& options) {
  const auto group = [](CLI::Option* option) { return option->group("Ground truth"); };
  group(command.add_option("--truth", options.truth,
                           "What goes into truth/: a list such as sharp,depth,flow, or all"))
      ->delimiter(',')
      ->check(CLI::IsMember(kTruths));
  RequireNumber(group(command.add_option("--imu-rate", options.request.imu.rate_hz,
                                         "Readings of the inertial sensor per second"))
                    ->capture_default_str(),
                1, 100000);
  group(command.add_option("--imu-noise", options.imu_noise,
                           "Its noise and bias: none, or euroc (an ADIS16448)"))
      ->check(CLI::IsMember({"none", "euroc"}))
      ->capture_default_str();
  RequireNumber(group(command.add_option("--pose-rate", options.request.truth.pose_rate_hz,
                                         "True poses per second in truth/poses.txt"))
                    ->capture_default_str(),
                0.1, 100000);
}

const char* const kFooter =
    "Layouts (--format):\n"
    "  tum         rgb/ depth/ rgb.txt depth.txt associations.txt groundtruth.txt camera.txt;\n"
    "              depth in 16 bits, 5000 per metre, along the optical axis\n"
    "  icl         scene_00_0000.png .depth .txt …: ICL-NUIM's own, fy < 0, depth along the ray\n"
    "  euroc       mav0/ with cam0 (gray), depth0, imu0 and state_groundtruth_estimate0\n"
    "  nerfstudio  transforms.json (OpenGL's camera axes), images/, depth/ (1000 per metre)\n"
    "  colmap      sparse/0 in text, with points, and images/, depth/\n"
    "  raw         frames/000000.raw: header, RGB, float depth and pose in one file, for\n"
    "              machines without image libraries\n"
    "Ground truth (--truth) is that of the pixels' centres at mid-exposure, free of noise:\n"
    "  sharp       PNG, without blur and noise, beside the pictures that have them\n"
    "  depth       float .npy along z and along the ray      normals  float .npy, two frames\n"
    "  ids         16-bit PNG of objects and materials, with their names in legend.json\n"
    "  flow        .flo to the next and the previous frame, with masks of what is hidden\n"
    "  imu, poses  imu.csv and poses.txt at rates of their own; euroc always has its imu0\n"
    "The pictures are the same for any number of threads. A render that was interrupted goes on\n"
    "when the same command is given again: a frame is there whole or not at all.\n"
    "Examples: silt render --scene office --trajectory desk --fps 20 --duration 2 --out office20\n"
    "          silt render --scene studio --truth flow,ids --format euroc --out studio-mav";

}  // namespace

void AddRenderCommand(CLI::App& program, const Invocation& invocation) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "render", "Render a sequence along a camera path, with its ground truth, into a folder");
  AddOutputOptions(*command, options->request);
  AddTruthOptions(*command, *options);
  AddSimulationOptions(*command, options->simulation, true);
  command
      ->add_flag("--allow-crossing", options->allow_crossing,
                 "Render also where the camera passes through surfaces of the scene")
      ->group("Simulation");
  command->footer(kFooter);
  command->callback([options, &invocation] { Run(*options, invocation); });
}

}  // namespace silt::experiments
