// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/reflection.h"

namespace silt::sim {

namespace {

PathOptions EndingIn(const Irradiance& irradiance) {
  PathOptions options;
  options.roulette = false;
  options.most_bounces = 8;  // between mirrors
  options.known_irradiance = [&irradiance](const TriangleHit& hit) {
    return irradiance.At(hit.triangle, hit.u, hit.v, hit.front);
  };
  return options;
}

}  // namespace

Reflection::Reflection(const Scene& scene, const RayTracer& tracer, const Irradiance& irradiance)
    : scene_(scene), tracer_(scene, tracer, EndingIn(irradiance)) {
  for (const Material& material : scene.materials) reflects_.push_back(material.reflects());
}

Vec3f Reflection::Over(const Vec3f& matt, const TriangleHit& hit, const Vec3f& direction) const {
  const Triangle& triangle = scene_.mesh.triangles[hit.triangle];
  const Material& material = scene_.materials[triangle.material];
  if (!hit.front && !material.two_sided) return matt;
  const Vec3f along = Normalized(direction);
  PathSampler samplers[kPaths];
  for (int i = 0; i < kPaths; ++i) samplers[i] = PathSampler(0, std::uint32_t(i));
  Vec3f radiance[kPaths];
  tracer_.TraceReflection(hit, along, samplers, radiance);
  Vec3f sum;
  for (const Vec3f& r : radiance) sum += r;
  // What a white ground under the coat would send on.
  const SurfacePoint point = MakeSurfacePoint(scene_, hit, true);
  const Vec3f ground = point.bsdf.GroundShare({Dot(-along, point.shading.tangent),
                                               Dot(-along, point.shading.bitangent),
                                               Dot(-along, point.shading.normal)});
  return ground * matt + (1.0f / kPaths) * sum;
}

}  // namespace silt::sim
