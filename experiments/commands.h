// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace silt::experiments {

// What every command may want to know of how it was called. Outlives the commands.
struct Invocation {
  std::string command_line;
};

// Each adds one subcommand, which runs when the command line has been parsed and throws silt::Error
// where it fails.
void AddRenderCommand(CLI::App& program, const Invocation& invocation);
void AddConvertCommand(CLI::App& program, const Invocation& invocation);
void AddTrackCommand(CLI::App& program, const Invocation& invocation);
void AddAlignCommand(CLI::App& program, const Invocation& invocation);
void AddEvaluateCommand(CLI::App& program, const Invocation& invocation);
void AddExperimentCommand(CLI::App& program, const Invocation& invocation);
void AddBenchCommand(CLI::App& program, const Invocation& invocation);
void AddSceneCommand(CLI::App& program, const Invocation& invocation);
void AddPathCommand(CLI::App& program, const Invocation& invocation);
void AddInfoCommand(CLI::App& program, const Invocation& invocation);

// Subcommands of `bench`.
void AddAlignBatchBench(CLI::App& bench, const Invocation& invocation);
void AddRenderBench(CLI::App& bench, const Invocation& invocation);
void AddTrackBench(CLI::App& bench, const Invocation& invocation);

// Subcommands of `experiment`.
void AddAblationExperiment(CLI::App& experiments, const Invocation& invocation);
void AddAccuracyExperiment(CLI::App& experiments, const Invocation& invocation);
void AddConvergenceExperiment(CLI::App& experiments, const Invocation& invocation);
void AddInitializationExperiment(CLI::App& experiments, const Invocation& invocation);
void AddLightExperiment(CLI::App& experiments, const Invocation& invocation);
void AddPhotoConsistencyExperiment(CLI::App& experiments, const Invocation& invocation);
void AddTimingExperiment(CLI::App& experiments, const Invocation& invocation);
void AddTrustExperiment(CLI::App& experiments, const Invocation& invocation);

}  // namespace silt::experiments
