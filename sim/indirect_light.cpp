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

float Brightness(const Vec3f& light) { return light.x + light.y + light.z; }

TangentFrame TurnedFrame(const Vec3f& normal, double turn) {
  TangentFrame frame(normal);
  const auto c = float(std::cos(turn)), s = float(std::sin(turn));
  const Vec3f tangent = c * frame.tangent + s * frame.bitangent;
  frame.bitangent = c * frame.bitangent - s * frame.tangent;
  frame.tangent = tangent;
  return frame;
}

}  // namespace

struct IndirectLight::Sums {
  Vec3f radiance;
  double brightness = 0, brightness_sq = 0;  // of packets
  double backs = 0, nearness = 0;
  float farthest_m = 0;
  int rays = 0, packets = 0;

  // Of the irradiance, from the packets: too large, since these are spread evenly among each other.
  double StandardError() const {
    const double mean = brightness / packets;
    const double variance = std::max(0.0, brightness_sq / packets - mean * mean);
    return std::numbers::pi * std::sqrt(variance / packets);
  }
};

IndirectLight::IndirectLight(const Scene& scene, const RayTracer& tracer, int directions,
                             std::uint64_t seed, const Rounds& rounds)
    : scene_(scene), tracer_(tracer), seed_(seed), rounds_(rounds) {
  // Each packet covers the whole hemisphere, so that one alone is an estimate.
  const std::vector<Vec3f> sorted = CosineDirections(directions);
  const std::size_t packets = (sorted.size() + kPacketSize - 1) / kPacketSize;
  for (std::size_t packet = 0; packet < packets; ++packet) {
    for (std::size_t i = packet; i < sorted.size(); i += packets) directions_.push_back(sorted[i]);
  }
}

void IndirectLight::AddPacket(const Vec3f& origin, const TangentFrame& frame, std::size_t first,
                              const SurfaceRadiance& radiance, Sums& sums) const {
  const int count = int(std::min<std::size_t>(kPacketSize, directions_.size() - first));
  Vec3f directions[kPacketSize];
  RayPacket rays;
  for (int i = 0; i < count; ++i) {
    directions[i] = frame.World(directions_[first + std::size_t(i)]);
    rays.Set(i, {origin, directions[i]});
  }
  HitPacket hits;
  tracer_.Trace(rays, hits);
  Vec3f sum;
  for (int i = 0; i < count; ++i) {
    if (hits.triangle[i] == kNoTriangle) {
      sums.farthest_m = rays.far[i];
      if (!scene_.environment) sum += scene_.ambient;
      continue;
    }
    const bool front = hits.cosine[i] < 0;
    sums.farthest_m = std::max(sums.farthest_m, hits.distance[i]);
    sums.nearness += 1 / std::max(hits.distance[i], 1e-4f);
    if (!front) ++sums.backs;
    sum += radiance({hits.triangle[i], hits.u[i], hits.v[i], front}, directions[i]);
  }
  sums.radiance += sum;
  const double brightness = double(Brightness(sum)) / count;
  sums.brightness += brightness;
  sums.brightness_sq += brightness * brightness;
  sums.rays += count;
  ++sums.packets;
}

Gathered IndirectLight::Gather(const Vec3f& position, const Vec3f& unit_normal, std::uint64_t place,
                               const SurfaceRadiance& radiance, const Vec3f& known) const {
  const CounterRandom random(seed_, place);
  const Vec3f origin = position + kRayOffsetM * unit_normal;
  Sums sums;
  const auto is_closed = [&] { return sums.packets > 0 && sums.farthest_m <= kBuriedM; };
  const auto is_precise = [&] {
    const double light = std::numbers::pi * sums.brightness / sums.packets + Brightness(known);
    return sums.StandardError() <= double(rounds_.tolerance) * light;
  };
  for (int round = 0; round < rounds_.most && !is_closed(); ++round) {
    if (round > 0 && is_precise()) break;
    const TangentFrame frame =
        TurnedFrame(unit_normal, 2 * std::numbers::pi * random.Uniform(std::uint64_t(round)));
    for (std::size_t first = 0; first < directions_.size() && !is_closed(); first += kPacketSize) {
      AddPacket(origin, frame, first, radiance, sums);
    }
  }
  Gathered result;
  result.irradiance = (std::numbers::pi_v<float> / float(sums.rays)) * sums.radiance;
  result.distance_m = sums.nearness > 0 ? float(double(sums.rays) / sums.nearness) : 1e30f;
  result.closed = sums.farthest_m <= kBuriedM || sums.backs >= kBacksOfBuried * double(sums.rays);
  result.buried = result.closed || result.distance_m <= kCoveredM;
  return result;
}

}  // namespace silt::sim
