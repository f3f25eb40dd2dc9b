// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/indirect_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "silt/core/random.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

namespace {

// A point that sees nothing farther than this is inside something, and one that on average sees no
// farther than that lies under something: a sheet on a table, say.
constexpr float kBuriedM = 0.02f, kCoveredM = 0.006f;
constexpr double kBacksOfBuried = 0.95;

TangentFrame TurnedFrame(const Vec3f& normal, double turn) {
  TangentFrame frame(normal);
  const auto c = float(std::cos(turn)), s = float(std::sin(turn));
  const Vec3f tangent = c * frame.tangent + s * frame.bitangent;
  frame.bitangent = c * frame.bitangent - s * frame.tangent;
  frame.tangent = tangent;
  return frame;
}

}  // namespace

IndirectLight::IndirectLight(const Scene& scene, const RayTracer& tracer, int directions,
                             std::uint64_t seed)
    : scene_(scene), tracer_(tracer), seed_(seed) {
  // Each packet covers the whole hemisphere, so that one alone is an estimate.
  const std::vector<Vec3f> sorted = CosineDirections(directions);
  const std::size_t packets = (sorted.size() + kPacketSize - 1) / kPacketSize;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    for (std::size_t i = packet; i < sorted.size(); i += packets) directions_.push_back(sorted[i]);
  }
}

Gathered IndirectLight::Gather(const Vec3f& position, const Vec3f& unit_normal, std::uint64_t place,
                               const SurfaceRadiance& radiance) const {
  const double turn = 2 * std::numbers::pi * CounterRandom(seed_, place).Uniform(0);
  const TangentFrame frame = TurnedFrame(unit_normal, turn);
  const Vec3f origin = position + kRayOffsetM * unit_normal;
  Vec3f sum;
  std::size_t traced = 0;
  double backs = 0, nearness = 0;
  float farthest_m = 0;
  while (traced < directions_.size() && (traced == 0 || farthest_m > kBuriedM)) {
    const int count = int(std::min<std::size_t>(kPacketSize, directions_.size() - traced));
    Vec3f directions[kPacketSize];
    RayPacket rays;
    for (int i = 0; i < count; ++i) {
      directions[i] = frame.World(directions_[traced + std::size_t(i)]);
      rays.Set(i, {origin, directions[i]});
    }
    HitPacket hits;
    tracer_.Trace(rays, hits);
    for (int i = 0; i < count; ++i) {
      if (hits.triangle[i] == kNoTriangle) {
        farthest_m = rays.far[i];
        if (!scene_.environment) sum += scene_.ambient;
        continue;
      }
      const bool front = hits.cosine[i] < 0;
      farthest_m = std::max(farthest_m, hits.distance[i]);
      nearness += 1 / std::max(hits.distance[i], 1e-4f);
      if (!front) ++backs;
      sum += radiance({hits.triangle[i], hits.u[i], hits.v[i], front}, directions[i]);
    }
    traced += std::size_t(count);
  }
  Gathered result;
  result.irradiance = (std::numbers::pi_v<float> / float(traced)) * sum;
  result.distance_m = nearness > 0 ? float(double(traced) / nearness) : 1e30f;
  result.buried = farthest_m <= kBuriedM || result.distance_m <= kCoveredM ||
                  backs >= kBacksOfBuried * double(traced);
  return result;
}

}  // namespace silt::sim
