// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor.h"

#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

SensorOptions SensorOptions::Preset(const std::string& name) {
  if (name == "none") return {};
  if (name == "handa") return {.noise = HandaNoise{}};
  if (name == "emva") return {.noise = EmvaNoise{}, .response = ResponseCurve::Linear()};
  throw Error("sensor noise: " + Quoted(name) + " is none of: none, handa, emva");
}

std::string SensorOptions::NoiseName() const {
  const char* const names[] = {"none", "handa", "emva"};
  return names[noise.index()];
}

void SensorOptions::Validate() const {
  if (const auto* handa = std::get_if<HandaNoise>(&noise)) handa->Validate();
  if (const auto* emva = std::get_if<EmvaNoise>(&noise)) emva->Validate();
}

Sensor::Sensor(const SensorOptions& options, const PinholeCamera& camera, const LensMap* lens)
    : options_(options), camera_(camera) {
  options_.Validate();
  if (options.vignetting.IsNone()) return;
  shares_ =
      std::make_shared<const Image<float>>(VignettingShares(options.vignetting, camera, lens));
}

Image<Vec3f> Sensor::Signal(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const {
  SILT_CHECK(radiance.width() == camera_.width && radiance.height() == camera_.height);
  const auto factor = float(exposure);
  for (Vec3f& value : radiance) value = factor * value;
  if (shares_ != nullptr) {
    const float* share = shares_->data();
    for (Vec3f& value : radiance) value = *share++ * value;
  }
  if (const auto* handa = std::get_if<HandaNoise>(&options_.noise)) AddNoise(*handa, key, radiance);
  if (const auto* emva = std::get_if<EmvaNoise>(&options_.noise)) AddNoise(*emva, key, radiance);
  return radiance;
}

Image<Rgb8> Sensor::Develop(Image<Vec3f> radiance, double exposure, const NoiseKey& key) const {
  return options_.response.Encode8(Signal(std::move(radiance), exposure, key));
}

Image<Vec3f> Sensor::DevelopFloat(Image<Vec3f> radiance, double exposure,
                                  const NoiseKey& key) const {
  Image<Vec3f> picture = Signal(std::move(radiance), exposure, key);
  const ResponseCurve& f = options_.response;
  ParallelFor(picture.height(), [&](int y) {
    Vec3f* row = picture.row(y);
    for (int x = 0; x < picture.width(); ++x) {
      row[x] = {float(f.Encode(double(row[x].x))), float(f.Encode(double(row[x].y))),
                float(f.Encode(double(row[x].z)))};
    }
  });
  return picture;
}

}  // namespace silt::sim
