// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/sensor_options.h"

namespace CLI {
class App;
}

namespace silt::experiments {

// The simulator on the command line, as `render` and `track` take it.
struct SimulationOptions {
  std::string scene, trajectory;
  double fps = 60, start_s = 0, duration_s = 0;
  int samples_per_pixel = 4, time_samples = 16, width = 640;
  double row_time_us = 0;
  std::string blur = "0", filter = "box", pattern = "shared";
  std::string light = "baked", exposure = "scene";
  bool specular = false;
  SensorCommandOptions sensor;
  std::uint64_t seed = 0;
  int threads = 0;

  // Throws silt::Error for values that the options cannot have together.
  RenderPlan Plan() const;
  sim::LightingOptions Lighting() const;
};

// --scene is asked for where `required`.
void AddSimulationOptions(CLI::App& command, SimulationOptions& options, bool required);

}  // namespace silt::experiments
