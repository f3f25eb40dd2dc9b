// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/error.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"
#include "silt/experiments/path_facts.h"
#include "silt/experiments/resources.h"
#include "silt/sim/path_file.h"
#include "silt/sim/scene.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file, scene, trajectory, json;
  double clearance_m = 0.05;
};

// The path file: given as such, or as a trajectory of a scene.
fs::path ChosenPath(const Options& options) {
  if (!options.file.empty()) return options.file;
  if (options.scene.empty()) throw Error("name a path file, or --scene (and --trajectory)");
  return PathFile(SceneFile(options.scene), options.trajectory);
}

void RunInfo(const Options& options) {
  const fs::path file = ChosenPath(options);
  const Json facts = PathFacts(sim::LoadCameraPath(file), file);
  if (!options.json.empty()) WriteJson(options.json, facts);
  if (options.json != "-") Print(FormatPathFacts(facts));
}

// Throws where the path crosses a surface or comes too near to one, after telling of all contacts.
void RunCheck(const Options& options) {
  const fs::path file = ChosenPath(options);
  const sim::CameraPath path = sim::LoadCameraPath(file);
  const sim::Scene scene = sim::LoadScene(SceneFile(options.scene));
  sim::PathCheckOptions check_options;
  check_options.clearance_m = options.clearance_m;
  const sim::PathCheck check = CheckPath(path, scene, check_options);
  std::string text;
  for (const sim::PathContact& contact : check.contacts) text += Describe(contact) + "\n";
  if (!options.json.empty()) {
    Json json{{"path", file.string()}, {"clearance_m", options.clearance_m}};
    json.update(ToJson(check));
    WriteJson(options.json, json);
  }
  if (options.json != "-") Print(text);
  if (check.contacts.empty()) {
    if (options.json != "-") Print(file.string() + ": keeps clear\n");
    return;
  }
  const std::string what = check.Crosses() ? "crosses surfaces" : "comes too near to surfaces";
  throw Error(file.string() + ": " + what + ", see above");
}

CLI::App* AddSubcommand(CLI::App& path, const char* name, const char* help,
                        const std::shared_ptr<Options>& options) {
  CLI::App* command = path.add_subcommand(name, help);
  command->add_option("file", options->file, "Path file (TOML; its format: sim/path_file.h)");
  command->add_option("--scene", options->scene, "Scene by name or path to its scene.toml");
  command->add_option("--trajectory", options->trajectory,
                      "Camera path beside the scene, by name, instead of a file");
  command->add_option("--json", options->json, "Write the figures to this file (-: to stdout)");
  return command;
}

}  // namespace

void AddPathCommand(CLI::App& program, const Invocation&) {
  const auto options = std::make_shared<Options>();
  CLI::App* path = program.add_subcommand("path", "Look at a camera path without rendering it");
  path->require_subcommand(1);
  CLI::App* info = AddSubcommand(
      *path, "info", "Length, speeds, turn rates, accelerations, residuals of a replay", options);
  info->footer("Example: silt path info --scene office --trajectory desk");
  info->callback([options] { RunInfo(*options); });
  CLI::App* check = AddSubcommand(
      *path, "check", "Check that it crosses no surface and keeps its distance", options);
  check->get_option("--scene")->required();
  RequireNumber(check
                    ->add_option("--clearance", options->clearance_m,
                                 "Least distance from the camera's centre to any surface, in "
                                 "metres; 0: only crossings matter")
                    ->capture_default_str(),
                0, 10);
  check->footer(
      "One line for each contact: when, and with which instance of the scene. Fails where there "
      "is\n"
      "one. Cut-outs count as solid.\n"
      "Example: silt path check --scene office --trajectory desk --clearance 0.1");
  check->callback([options] { RunCheck(*options); });
}

}  // namespace silt::experiments
