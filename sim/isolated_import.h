// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "silt/sim/model_import.h"

namespace silt::sim {

struct ImportTask {
  const AssetSource* source;
  std::string path;
};

// One of both.
struct ImportOutcome {
  std::optional<Model> model;
  std::string problem;  // one line that names the file
};

// What the import of one model may take.
struct ImportLimits {
  double time_s = 30;
  std::size_t memory_bytes = std::size_t(2) << 30;  // of its child process
};

using Importer = std::function<Model(const AssetSource&, const std::string&)>;

// Imports models in child processes, ThreadCount() at a time, so that a file that crashes, hangs or
// starves the import library is refused in one line and this process goes on. Outcomes are in the
// order of the tasks and the same for any number of threads. What the children send is checked.
// Throws silt::Error where no child process can be started.
std::vector<ImportOutcome> ImportIsolated(const std::vector<ImportTask>& tasks,
                                          const ImportLimits& limits = {},
                                          const Importer& importer = ImportModel);

}  // namespace silt::sim
