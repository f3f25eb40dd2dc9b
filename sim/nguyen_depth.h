// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/depth_sensor.h"

namespace silt::sim {

// A Kinect's noise by Nguyen, Izadi and Lovell, "Modeling Kinect Sensor Noise for Improved 3D
// Reconstruction and Tracking", 3DIMPVT 2012; z in metres, θ in radians between ray and normal:
//   axial    σ_z = 0.0012 + 0.0019·(z − 0.4)² + 0.0001/√z · θ²/(π/2 − θ)²,
//   lateral  σ_L = 0.8 + 0.035·θ/(π/2 − θ) pixels, along columns and rows.
// Measured from 0.4 to 2.75 m and up to about 80°, beyond which θ stays at 80°.
class NguyenDepth : public DepthSensor {
 public:
  static double AxialSigma(double z, double theta);
  static double LateralSigma(double theta);
  Image<float> Measure(const DepthView& view, const NoiseKey& key) const override;
};

}  // namespace silt::sim
