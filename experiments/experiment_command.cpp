// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "silt/experiments/commands.h"

namespace silt::experiments {

void AddExperimentCommand(CLI::App& program, const Invocation& invocation) {
  CLI::App* command =
      program.add_subcommand("experiment", "Repeat an experiment of the paper and report on it");
  command->require_subcommand(1);
  AddAblationExperiment(*command, invocation);
  AddAccuracyExperiment(*command, invocation);
  AddConvergenceExperiment(*command, invocation);
  AddInitializationExperiment(*command, invocation);
  AddLightExperiment(*command, invocation);
  AddPhotoConsistencyExperiment(*command, invocation);
  AddTimingExperiment(*command, invocation);
  AddTrustExperiment(*command, invocation);
}

}  // namespace silt::experiments
