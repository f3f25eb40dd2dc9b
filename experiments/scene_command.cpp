// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/core/error.h"
#include "silt/experiments/commands.h"
#include "silt/experiments/output.h"
#include "silt/experiments/resources.h"
#include "silt/experiments/scene_facts.h"
#include "silt/sim/scene_check.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string scene, json;
  bool all = false, strict = false;
};

void RunInfo(const Options& options) {
  const std::filesystem::path file = SceneFile(options.scene);
  const Json facts = SceneFacts(sim::LoadScene(file), file);
  if (!options.json.empty()) WriteJson(options.json, facts);
  if (options.json != "-") Print(FormatSceneFacts(facts, options.all ? 1 << 30 : 20));
}

// Throws where there are errors, after telling of all that was found.
void RunCheck(const Options& options) {
  const std::filesystem::path file = SceneFile(options.scene);
  const auto findings = sim::CheckScene(sim::LoadScene(file));
  Json list = Json::array();
  std::string text;
  int errors = 0;
  for (const sim::SceneFinding& finding : findings) {
    const char* const kind = finding.is_error ? "error" : "warning";
    errors += finding.is_error;
    text += std::string(kind) + ": " + finding.message + "\n";
    list.push_back({{"kind", kind}, {"message", finding.message}});
  }
  const int warnings = int(findings.size()) - errors;
  text += file.string() + ": " + std::to_string(errors) + " errors, " + std::to_string(warnings) +
          " warnings\n";
  if (!options.json.empty()) {
    WriteJson(
        options.json,
        {{"file", file.string()}, {"errors", errors}, {"warnings", warnings}, {"findings", list}});
  }
  if (options.json != "-") Print(text);
  if (errors > 0) throw Error(file.string() + ": the scene has errors, see above");
  if (options.strict && warnings > 0) {
    throw Error(file.string() + ": the scene has warnings, see above (--strict)");
  }
}

CLI::App* AddSubcommand(CLI::App& scene, const char* name, const char* help,
                        const std::shared_ptr<Options>& options) {
  CLI::App* command = scene.add_subcommand(name, help);
  command
      ->add_option("scene,--scene", options->scene,
                   "Scene by name (silt info lists them) or path to its scene.toml")
      ->required();
  command->add_option("--json", options->json, "Write the same to this file (-: to stdout)");
  return command;
}

}  // namespace

void AddSceneCommand(CLI::App& program, const Invocation&) {
  const auto options = std::make_shared<Options>();
  CLI::App* scene = program.add_subcommand("scene", "Look at a scene without rendering it");
  scene->require_subcommand(1);
  CLI::App* info = AddSubcommand(
      *scene, "info", "Sizes, triangles, memory, lights, materials, textures, instances", options);
  info->add_flag("--all", options->all, "List all instances, not the 20 largest");
  info->callback([options] { RunInfo(*options); });
  CLI::App* check = AddSubcommand(*scene, "check", "Look for what is wrong with it", options);
  check->add_flag("--strict", options->strict, "Fail for warnings too");
  check->footer(
      "One line for each finding. Errors, for which the command fails: nothing lights the scene,\n"
      "materials that reflect more than they receive, broken vertices or normals, empty "
      "instances.\n"
      "Warnings: missing textures; triangles without area; normals on the wrong side; surfaces "
      "that\n"
      "rays can reach and that lie on each other within 0.01 mm, so that rounding decides which "
      "of\n"
      "them is seen; instances that float or reach below the floor.\n"
      "Example: silt scene check office");
  check->callback([options] { RunCheck(*options); });
}

}  // namespace silt::experiments
