// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/sensor_noise.h"

namespace silt::sim {

struct SensorOptions {
  NoiseModel noise = {};  // none, unless given

  void Validate() const;  // throws silt::Error
};

// What a camera makes of radiance: × exposure → noise → response curve → 8 bits.
class Sensor {
 public:
  // `camera` is the one whose radiance is developed.
  Sensor(const SensorOptions& options, const PinholeCamera& camera);

  // The linear signal in [0, 1] (a little beyond it with noise) of linear radiance, before the
  // response curve; radiance × exposure = 1 is white.
  Image<Vec3f> Signal(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const;

  // The picture: Signal() through the response curve and rounded to 8 bits.
  Image<Rgb8> Develop(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const;

  const SensorOptions& options() const { return options_; }

 private:
  SensorOptions options_;
  PinholeCamera camera_;
};

}  // namespace silt::sim
