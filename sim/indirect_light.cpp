// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/indirect_light.h"

#include <algorithm>
#include <numbers>

#include "silt/sim/direct_light.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

namespace {

// A point that sees nothing farther than this is inside something: a rough value will do.
constexpr float kBuriedM = 0.02f;

}  // namespace

IndirectLight::IndirectLight(const Scene& scene, const RayTracer& tracer, int directions)
    : scene_(scene), tracer_(tracer) {
  // Each packet covers the whole hemisphere, so that one alone is an estimate.
  const std::vector<Vec3f> sorted = CosineDirections(directions);
  const std::size_t packets = (sorted.size() + kPacketSize - 1) / kPacketSize;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    for (std::size_t i = packet; i < sorted.size(); i += packets) directions_.push_back(sorted[i]);
  }
}

Vec3f IndirectLight::Irradiance(const Vec3f& position, const Vec3f& unit_normal,
                                const SurfaceRadiance& radiance) const {
  const TangentFrame frame(unit_normal);
  const Vec3f origin = position + kRayOffsetM * unit_normal;
  Vec3f sum;
  std::size_t traced = 0;
  float farthest_m = 0;
  while (traced < directions_.size() && (traced == 0 || farthest_m > kBuriedM)) {
    const int count = int(std::min<std::size_t>(kPacketSize, directions_.size() - traced));
    RayPacket rays;
    for (int i = 0; i < count; ++i) {
      rays.Set(i, {origin, frame.World(directions_[traced + std::size_t(i)])});
    }
    HitPacket hits;
    tracer_.Trace(rays, hits);
    for (int i = 0; i < count; ++i) {
      const bool missed = hits.triangle[i] == kNoTriangle;
      farthest_m = std::max(farthest_m, missed ? rays.far[i] : hits.distance[i]);
      sum += missed ? scene_.Background(frame.World(directions_[traced + std::size_t(i)]))
                    : radiance(hits.triangle[i], hits.u[i], hits.v[i], hits.cosine[i] < 0);
    }
    traced += std::size_t(count);
  }
  return (std::numbers::pi_v<float> / float(traced)) * sum;
}

}  // namespace silt::sim
