// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/depth_sensor.h"

namespace silt::sim {

// The random error of a Kinect by Khoshelham and Elberink, "Accuracy and Resolution of Kinect Depth
// Data for Indoor Mapping Applications", Sensors 2012: Gaussian, σ_z = 1.425e-3·z² metres.
class KhoshelhamDepth : public DepthSensor {
 public:
  Image<float> Measure(const DepthView& view, const NoiseKey& key) const override;
};

}  // namespace silt::sim
