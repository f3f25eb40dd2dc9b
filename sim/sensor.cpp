// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor.h"

#include <utility>

#include "silt/core/error.h"
#include "silt/sim/response_curve.h"

namespace silt::sim {

void SensorOptions::Validate() const {
  if (const auto* handa = std::get_if<HandaNoise>(&noise)) handa->Validate();
}

Sensor::Sensor(const SensorOptions& options, const PinholeCamera& camera)
    : options_(options), camera_(camera) {
  options_.Validate();
}

Image<Vec3f> Sensor::Signal(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const {
  SILT_CHECK(radiance.width() == camera_.width && radiance.height() == camera_.height);
  for (Vec3f& value : radiance) value = float(exposure) * value;
  if (const auto* handa = std::get_if<HandaNoise>(&options_.noise)) AddNoise(*handa, key, radiance);
  return radiance;
}

Image<Rgb8> Sensor::Develop(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const {
  return EncodeSrgb8(Signal(std::move(radiance), exposure, key));
}

}  // namespace silt::sim
