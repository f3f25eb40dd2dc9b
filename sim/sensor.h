// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/emva_noise.h"
#include "silt/sim/handa_noise.h"
#include "silt/sim/lens_map.h"
#include "silt/sim/noise_key.h"
#include "silt/sim/response_curve.h"
#include "silt/sim/vignetting.h"

namespace silt::sim {

// The first of them: none.
using NoiseModel = std::variant<std::monostate, HandaNoise, EmvaNoise>;

struct SensorOptions {
  NoiseModel noise = {};
  ResponseCurve response = {};  // sRGB
  Vignetting vignetting = {};   // none

  // A noise model's name with the response curve that it declares: "none" (sRGB), "handa" (sRGB)
  // and "emva" (linear, as the standard asks). Throws silt::Error for another name.
  static SensorOptions Preset(const std::string& name);
  // "none", "handa" or "emva".
  std::string NoiseName() const;

  void Validate() const;  // throws silt::Error
};

// What a camera makes of radiance: × exposure → vignetting → noise → response curve → 8 bits.
class Sensor {
 public:
  // `camera` is the one whose radiance is developed, seen through `lens`, which may be null.
  Sensor(const SensorOptions& options, const PinholeCamera& camera, const LensMap* lens = nullptr);

  // The linear signal of radiance, before the response curve: radiance × exposure = 1 at the
  // picture's centre is white. With noise, values a little outside [0, 1] occur.
  Image<Vec3f> Signal(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const;

  // The picture in 8 bits.
  Image<Rgb8> Develop(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const;
  // The same in [0, 1], without rounding.
  Image<Vec3f> DevelopFloat(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const;

  const SensorOptions& options() const { return options_; }

 private:
  SensorOptions options_;
  PinholeCamera camera_;
  std::shared_ptr<const Image<float>> shares_;  // of the light, by pixel; null: all of it
};

}  // namespace silt::sim
