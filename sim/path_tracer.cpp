// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace silt::sim {

namespace {

constexpr float kInversePi = std::numbers::inv_pi_v<float>;
// A shadow ray ends a little before the light, which is part of the mesh.
constexpr float kShadowEnd = 1 - 1e-5f;
constexpr int kBouncesBeforeRoulette = 3;
constexpr float kLeastSurvival = 0.05f;
// What is seen itself gets light from each emitter, if they are so many at most; elsewhere, and
// where they are more, one is chosen.
constexpr std::size_t kMostAimedAtEach = 12;

// A vertex that a path reflects at.
struct Vertex {
  SurfacePoint point;
  Bsdf bsdf;  // that of the point, or its reflecting part
  Vec3f out;  // towards the viewer, in the shading frame
};

Vec3f Local(const TangentFrame& frame, const Vec3f& world) {
  return {Dot(world, frame.tangent), Dot(world, frame.bitangent), Dot(world, frame.normal)};
}

Emitters::Receiver ReceiverAt(const SurfacePoint& point, bool aims_at_each) {
  return {point.origin, point.shading.normal, aims_at_each};
}

Vec3f DirectionOf(const RayPacket& rays, int lane) {
  return {rays.direction_x[lane], rays.direction_y[lane], rays.direction_z[lane]};
}

bool AnyValid(const RayPacket& rays) {
  return std::any_of(std::begin(rays.valid), std::end(rays.valid), [](int v) { return v != 0; });
}

float Balance(float mine, float other) { return mine / (mine + other); }

}  // namespace

struct PathTracer::Paths {
  RayPacket rays;  // of unit directions; a lane whose path has ended is not valid
  Vec3f throughput[kPacketSize], radiance[kPacketSize];
  // How the ray was drawn: from where, and how densely; 0: the only possible direction.
  Emitters::Receiver from[kPacketSize];
  float density[kPacketSize] = {};
  std::optional<Vertex> vertex[kPacketSize];
  bool aims_at_each = false;  // at the present vertex
  RayPacket shadow_rays;
  Vec3f aimed[kPacketSize];  // radiance that arrives where a shadow ray is free

  explicit Paths(const RayPacket& first) : rays(first) {
    for (int i = 0; i < kPacketSize; ++i) {
      if (!rays.valid[i]) continue;
      throughput[i] = {1, 1, 1};
      const Vec3f direction = Normalized(DirectionOf(first, i));
      const Vec3f origin{first.origin_x[i], first.origin_y[i], first.origin_z[i]};
      rays.Set(i, {origin, direction});
    }
  }
};

PathTracer::PathTracer(const Scene& scene, const RayTracer& tracer, PathOptions options)
    : scene_(scene), tracer_(tracer), options_(std::move(options)), emitters_(scene) {}

void PathTracer::Trace(const RayPacket& rays, Samplers& samplers, Radiances& radiance) const {
  Paths paths(rays);
  Run(paths, samplers, 0);
  std::copy(std::begin(paths.radiance), std::end(paths.radiance), radiance);
}

void PathTracer::TraceReflection(const TriangleHit& hit, const Vec3f& direction, Samplers& samplers,
                                 Radiances& radiance) const {
  const SurfacePoint point = MakeSurfacePoint(scene_, hit, true);
  RayPacket rays;
  for (int i = 0; i < kPacketSize; ++i) rays.Set(i, {point.origin, direction});
  Paths paths(rays);
  for (auto& vertex : paths.vertex) {
    vertex = Vertex{point, point.bsdf.Reflection(), Local(point.shading, -direction)};
  }
  Scatter(paths, samplers, 0);
  Run(paths, samplers, 1);
  std::copy(std::begin(paths.radiance), std::end(paths.radiance), radiance);
}

void PathTracer::Run(Paths& paths, Samplers& samplers, int bounce) const {
  for (; bounce <= options_.most_bounces && AnyValid(paths.rays); ++bounce) {
    HitPacket hits;
    tracer_.Trace(paths.rays, hits);
    for (int i = 0; i < kPacketSize; ++i) {
      if (!paths.rays.valid[i]) continue;
      paths.vertex[i].reset();
      if (hits.triangle[i] == kNoTriangle) {
        Leave(paths, i);
      } else {
        Meet(paths, hits, i);
      }
      if (!paths.vertex[i]) paths.rays.valid[i] = 0;
    }
    if (bounce < options_.most_bounces) Scatter(paths, samplers, bounce);
  }
}

// At every vertex: the light that is aimed at, and the path's next ray.
void PathTracer::Scatter(Paths& paths, Samplers& samplers, int bounce) const {
  paths.aims_at_each = bounce == 0 && emitters_.count() <= kMostAimedAtEach;
  const std::size_t rounds = paths.aims_at_each ? emitters_.count() : 1;
  for (std::size_t emitter = 0; emitter < rounds; ++emitter) {
    std::fill(std::begin(paths.shadow_rays.valid), std::end(paths.shadow_rays.valid), 0);
    for (int i = 0; i < kPacketSize; ++i) {
      if (paths.rays.valid[i]) Aim(paths, samplers[i], i, emitter);
    }
    const std::uint32_t occluded =
        AnyValid(paths.shadow_rays) ? tracer_.Occluded(paths.shadow_rays) : 0;
    for (int i = 0; i < kPacketSize; ++i) {
      if (paths.shadow_rays.valid[i] && !(occluded >> i & 1)) paths.radiance[i] += paths.aimed[i];
    }
  }
  for (int i = 0; i < kPacketSize; ++i) {
    if (paths.rays.valid[i]) Reflect(paths, samplers[i], i, bounce);
  }
}

// The ray meets nothing.
void PathTracer::Leave(Paths& paths, int lane) const {
  const Vec3f direction = DirectionOf(paths.rays, lane);
  const bool drawn = scene_.environment && paths.density[lane] > 0;
  float share = 1;
  if (drawn && options_.strategy == LightStrategy::kAim) share = 0;
  if (drawn && options_.strategy == LightStrategy::kBoth) {
    share = Balance(paths.density[lane], emitters_.BackgroundDensity(paths.from[lane], direction));
  }
  paths.radiance[lane] += share * (paths.throughput[lane] * scene_.Background(direction));
}

// Adds what the surface itself sends, and makes it the path's vertex where there is more to come.
void PathTracer::Meet(Paths& paths, const HitPacket& hits, int lane) const {
  const TriangleHit hit{hits.triangle[lane], hits.u[lane], hits.v[lane], hits.cosine[lane] < 0};
  const SurfacePoint point = MakeSurfacePoint(scene_, hit, options_.reflection);
  if (point.black) return;
  float share = 1;
  if (paths.density[lane] > 0) {
    const float aimed =
        emitters_.Density(paths.from[lane], {hit.triangle, hits.distance[lane], hits.cosine[lane]});
    if (options_.strategy == LightStrategy::kBoth) share = Balance(paths.density[lane], aimed);
    if (options_.strategy == LightStrategy::kAim && aimed > 0) share = 0;
  }
  const Vec3f& throughput = paths.throughput[lane];
  paths.radiance[lane] += share * (throughput * point.emission);
  const Vec3f out = Local(point.shading, -DirectionOf(paths.rays, lane));
  if (!options_.known_irradiance) {
    paths.vertex[lane] = Vertex{point, point.bsdf, out};
    return;
  }
  if (!point.bsdf.is_mirror()) {
    paths.radiance[lane] +=
        kInversePi * (throughput * point.bsdf.GroundAlbedo(out) * options_.known_irradiance(hit));
  }
  if (point.bsdf.is_mirror() || point.bsdf.is_glossy()) {
    paths.vertex[lane] = Vertex{point, point.bsdf.Reflection(), out};
  }
}

// Draws a point of the emitter, or of one that is chosen, and the shadow ray to it.
void PathTracer::Aim(Paths& paths, PathSampler& sampler, int lane, std::size_t emitter) const {
  const float choice = sampler.Next();
  const Vec2f random = sampler.Next2();
  const Vertex& vertex = *paths.vertex[lane];
  if (options_.strategy == LightStrategy::kMeet || vertex.bsdf.is_mirror()) return;
  const Emitters::Receiver at = ReceiverAt(vertex.point, paths.aims_at_each);
  const Emitters::Sample light = paths.aims_at_each
                                     ? emitters_.DrawFrom(emitter, at, choice, random)
                                     : emitters_.Draw(at, choice, random);
  if (!(light.density > 0)) return;
  const Vec3f in = Local(vertex.point.shading, light.direction);
  const Vec3f reflected = vertex.bsdf.Evaluate(vertex.out, in);
  if (!(std::max({reflected.x, reflected.y, reflected.z}) > 0)) return;
  float share = 1;
  if (options_.strategy == LightStrategy::kBoth) {
    share = Balance(light.density, vertex.bsdf.Density(vertex.out, in));
  }
  paths.aimed[lane] =
      (share / light.density) * (paths.throughput[lane] * reflected * light.radiance);
  paths.shadow_rays.Set(
      lane, {vertex.point.origin, light.direction, 0, light.distance * kShadowEnd - kRayOffsetM});
}

void PathTracer::Reflect(Paths& paths, PathSampler& sampler, int lane, int bounce) const {
  const float lobe = sampler.Next(), survival = sampler.Next();
  const Vec2f random = sampler.Next2();
  const Vertex& vertex = *paths.vertex[lane];
  const Bsdf::Sample drawn = vertex.bsdf.Draw(vertex.out, lobe, random);
  Vec3f& throughput = paths.throughput[lane];
  throughput = throughput * drawn.weight;
  const float most = std::max({throughput.x, throughput.y, throughput.z});
  bool goes_on = most > 0;
  if (options_.roulette && bounce + 1 >= kBouncesBeforeRoulette) {
    // Of paths that carry little, more go on than in proportion: theirs is much of the noise.
    const float chance = std::clamp(std::sqrt(most), kLeastSurvival, 1.0f);
    goes_on = goes_on && survival < chance;
    throughput = (1 / chance) * throughput;
  }
  paths.rays.valid[lane] = 0;
  if (!goes_on) return;
  paths.from[lane] = ReceiverAt(vertex.point, paths.aims_at_each);
  paths.density[lane] = drawn.density;
  paths.rays.Set(lane, {vertex.point.origin, vertex.point.shading.World(drawn.in)});
}

}  // namespace silt::sim
