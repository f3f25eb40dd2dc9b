// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/environment_light.h"

#include <algorithm>

#include "silt/sim/sampling.h"

namespace silt::sim {

EnvironmentLight::EnvironmentLight(const Scene& scene, const RayTracer& tracer, int directions)
    : tracer_(tracer) {
  if (!scene.environment) return;
  for (const Vec2d& place : SquareSamples(directions)) {
    const Vec2f random{float(std::clamp(place.x, 0.0, 0.999999)),
                       float(std::clamp(place.y, 0.0, 0.999999))};
    const Environment::Sample drawn = scene.environment->Draw(random);
    if (!(drawn.density > 0)) continue;
    beams_.push_back({drawn.direction, (1 / (float(directions) * drawn.density)) * drawn.radiance});
  }
}

Vec3f EnvironmentLight::Irradiance(const Vec3f& position, const Vec3f& unit_normal) const {
  const Vec3f origin = position + kRayOffsetM * unit_normal;
  Vec3f sum;
  for (std::size_t first = 0; first < beams_.size(); first += kPacketSize) {
    const int count = int(std::min<std::size_t>(kPacketSize, beams_.size() - first));
    RayPacket rays;
    for (int i = 0; i < count; ++i) {
      const Vec3f& direction = beams_[first + std::size_t(i)].direction;
      if (Dot(direction, unit_normal) > 0) rays.Set(i, {origin, direction});
    }
    const std::uint32_t occluded = tracer_.Occluded(rays);
    for (int i = 0; i < count; ++i) {
      if (rays.valid[i] == 0 || (occluded >> i & 1)) continue;
      const Beam& beam = beams_[first + std::size_t(i)];
      sum += Dot(beam.direction, unit_normal) * beam.power;
    }
  }
  return sum;
}

}  // namespace silt::sim
