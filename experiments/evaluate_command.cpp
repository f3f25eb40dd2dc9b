// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/experiments/commands.h"
#include "silt/experiments/evaluation.h"
#include "silt/experiments/option_checks.h"
#include "silt/experiments/output.h"

namespace silt::experiments {
namespace {

struct Options {
  std::string truth, estimate, json;
  EvaluationOptions evaluation;
};

void Run(const Options& options) {
  const Trajectory truth = ReadTumTrajectory(options.truth);
  const Trajectory estimate = ReadTumTrajectory(options.estimate);
  const Evaluation evaluation = Evaluate(truth, estimate, options.evaluation);
  if (!options.json.empty()) WriteJson(options.json, ToJson(evaluation));
  if (options.json != "-") Print(FormatEvaluation(evaluation));
}

}  // namespace

void AddEvaluateCommand(CLI::App& program, const Invocation&) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "evaluate", "Compare an estimated trajectory with the true one, both in TUM's format");
  command->add_option("truth", options->truth, "True trajectory: time tx ty tz qx qy qz qw")
      ->required();
  command->add_option("estimate", options->estimate, "Estimated trajectory")->required();
  command->add_option("--json", options->json, "Write the figures to this file (-: to stdout)");
  const std::map<std::string, Convention> names{{"evo", Convention::kEvo},
                                                {"tum", Convention::kTum}};
  command
      ->add_option_function<std::string>(
          "--convention",
          [options, names](const std::string& name) {
            options->evaluation.convention = names.at(name);
          },
          "evo: poses within 0.01 s, consecutive RPE windows; tum: within 0.02 s, overlapping "
          "windows, as TUM's scripts")
      ->check(CLI::IsMember({"evo", "tum"}))
      ->default_str("evo");
  RequireNumber(command->add_option("--frames", options->evaluation.frames, "RPE window in frames")
                    ->capture_default_str(),
                1, 1e9);
  RequireNumber(
      command->add_option("--seconds", options->evaluation.seconds, "RPE window in seconds")
          ->capture_default_str(),
      1e-6, 1e9);
  RequireNumber(
      command->add_option("--metres", options->evaluation.metres, "RPE window in metres of path")
          ->capture_default_str(),
      1e-6, 1e9);
  command->footer(
      "position: the first poses are made equal and nothing else is aligned, as in the paper;\n"
      "orientation: log(R_true^T R_estimated) about the axes of the true camera;\n"
      "ATE: after the best rigid alignment; RPE: drift over a window.\n"
      "Example: silt evaluate groundtruth.txt estimate.txt --json figures.json");
  command->callback([options] { Run(*options); });
}

}  // namespace silt::experiments
