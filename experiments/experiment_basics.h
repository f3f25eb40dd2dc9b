// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"

namespace CLI {
class App;
}

namespace silt::experiments {

// What every experiment on a scene lets the user choose.
struct ExperimentBasics {
  std::string scene, trajectory, backend = "cpu", out;
  int width = 0, samples_per_pixel = 4, threads = 0;
  std::uint64_t seed = 0;
  bool quick = false;

  // With --quick's or the usual values for what was not chosen: the studio at 320×240, or the
  // office at 640×480.
  ExperimentBasics Resolved() const;

  // The paper's camera and shutter.
  sim::RenderOptions Rendering(bool blur_and_noise) const;
  World Load() const { return LoadWorld(scene, trajectory); }
  Json ToJson() const;
};

void AddExperimentBasics(CLI::App& command, ExperimentBasics& basics);

}  // namespace silt::experiments
