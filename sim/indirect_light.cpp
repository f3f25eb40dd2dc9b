// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/indirect_light.h"

#include <algorithm>
#include <numbers>

#include "silt/sim/direct_light.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

IndirectLight::IndirectLight(const Scene& scene, const RayTracer& tracer, int directions)
    : scene_(scene), tracer_(tracer), directions_(CosineDirections(directions)) {}

Vec3f IndirectLight::Irradiance(const Vec3f& position, const Vec3f& unit_normal,
                                const SurfaceRadiance& radiance) const {
  const TangentFrame frame(unit_normal);
  const Vec3f origin = position + kRayOffsetM * unit_normal;
  Vec3f sum;
  for (std::size_t first = 0; first < directions_.size(); first += kPacketSize) {
    const int count = int(std::min<std::size_t>(kPacketSize, directions_.size() - first));
    RayPacket rays;
    for (int i = 0; i < count; ++i) {
      rays.Set(i, {origin, frame.World(directions_[first + std::size_t(i)])});
    }
    HitPacket hits;
    tracer_.Trace(rays, hits);
    for (int i = 0; i < count; ++i) {
      const std::uint32_t triangle = hits.triangle[i];
      sum += triangle == kNoTriangle ? scene_.ambient
                                     : radiance(triangle, hits.u[i], hits.v[i], hits.cosine[i] < 0);
    }
  }
  return (std::numbers::pi_v<float> / float(directions_.size())) * sum;
}

}  // namespace silt::sim
