// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "silt/core/image.h"
#include "silt/sim/depth_dropouts.h"
#include "silt/sim/depth_view.h"
#include "silt/sim/noise_key.h"

namespace silt::sim {

// What a depth camera measures: depth along z in metres, 0 where it measures nothing. The noise of
// a pixel is a function of (seed, frame, pixel) alone.
class DepthSensor {
 public:
  virtual ~DepthSensor() = default;
  virtual Image<float> Measure(const DepthView& view, const NoiseKey& key) const = 0;
};

struct DepthSensorOptions {
  std::string model = "perfect";  // one of DepthSensorModels()
  DepthDropouts dropouts = {};    // none, unless asked for

  void Validate() const;  // throws silt::Error
};

// perfect; png16, the same in the 1/5000 m steps of TUM's PNG files; kinect, kinect-legacy,
// khoshelham, nguyen: see the header of each.
const std::vector<std::string>& DepthSensorModels();

// The sensor with its dropouts. Throws silt::Error for options that are none.
std::shared_ptr<const DepthSensor> MakeDepthSensor(const DepthSensorOptions& options);

}  // namespace silt::sim
