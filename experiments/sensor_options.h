// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/json.h"
#include "silt/sim/renderer.h"

namespace CLI {
class App;
}

namespace silt::experiments {

// The camera's lens and sensors on the command line. What is left empty is the file's, or else
// none.
struct SensorCommandOptions {
  std::string file = {}, noise = {}, response = {}, vignetting = {}, depth_model = {};
  std::vector<double> lens = {};  // k1 k2 p1 p2 k3
  double photons = 0;             // of a white pixel; 0: the noise model's
  bool depth_dropouts = false;

  // Sets sensor, lens and depth sensor. Throws silt::Error for what they cannot be.
  void Apply(sim::RenderOptions& options) const;
};

void AddSensorOptions(CLI::App& command, SensorCommandOptions& options);

// Sensor, lens and depth sensor in full, for a manifest.
Json SensorJson(const sim::RenderOptions& options);

}  // namespace silt::experiments
