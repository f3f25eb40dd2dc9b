// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "silt/core/lens.h"
#include "silt/sim/depth_sensor.h"
#include "silt/sim/sensor.h"

namespace silt::sim {

// A camera's lens and sensors, as a file describes them.
struct SensorSetup {
  SensorOptions sensor;
  LensDistortion lens;
  DepthSensorOptions depth;
};

// Reads a TOML file. All of it may be left out:
//   response = "srgb"            srgb, linear, gamma:G, or a table beside the file
//   (response_curve.h);
//                                default: what the noise model declares
//   [noise]                      model = "none", "handa" or "emva", and its constants
//   (handa_noise.h:
//                                sigma_shot, sigma_read; emva_noise.h: all by their names)
//   [vignetting]                 cos4 = true or false, polynomial = [a1, a2, a3]
//   [lens]                       k1, k2, p1, p2, k3
//   [depth]                      model (depth_sensor.h), grazing_deg, edge_share, edge_px,
//                                shadow_baseline_m (depth_dropouts.h)
// Throws silt::Error with file and line.
SensorSetup LoadSensorFile(const std::filesystem::path& file);

}  // namespace silt::sim
