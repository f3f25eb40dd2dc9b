// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "silt/experiments/commands.h"

namespace silt::experiments {

void AddBenchCommand(CLI::App& program, const Invocation& invocation) {
  CLI::App* command = program.add_subcommand("bench", "Measure silt's speed on this machine");
  command->require_subcommand(1);
  AddRenderBench(*command, invocation);
  AddTrackBench(*command, invocation);
  AddAlignBatchBench(*command, invocation);
}

}  // namespace silt::experiments
