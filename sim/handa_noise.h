// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/noise_key.h"

namespace silt::sim {

// Shot and read noise of a colour camera: a signal I in [0, 1], linear in light, gets Gaussian
// noise of variance σ_s²·I + σ_c², per channel, before the response curve and the 8 bits. The
// constants are those released with Handa et al., "Real-Time Camera Tracking: When is High
// Frame-Rate Best?", ECCV 2012.
struct HandaNoise {
  Vec3d sigma_shot{0.0104, 0.0066, 0.0106};
  Vec3d sigma_read{0.0045, 0.0038, 0.0050};

  void Validate() const;  // throws silt::Error
};

// Adds noise to a signal (values outside [0, 1] count as saturated). A pixel's noise is a function
// of (seed, frame, pixel, channel) alone.
void AddNoise(const HandaNoise& model, const NoiseKey& key, Image<Vec3f>& signal);

}  // namespace silt::sim
