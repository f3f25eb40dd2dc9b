// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/direct_light.h"

#include <algorithm>

#include "silt/sim/form_factor.h"
#include "silt/sim/sampling.h"

namespace silt::sim {

namespace {

// A shadow ray ends this much before the light, which is part of the mesh.
constexpr float kShadowEnd = 1 - 1e-3f;

}  // namespace

DirectLight::DirectLight(const Scene& scene, const RayTracer& tracer, int points_per_light)
    : scene_(scene), tracer_(tracer) {
  for (const RectLight& light : scene.lights) {
    std::vector<Vec3f>& points = points_.emplace_back();
    for (const Vec2d& s : SquareSamples(points_per_light)) {
      points.push_back(light.center + float(2 * s.x - 1) * light.half_u +
                       float(2 * s.y - 1) * light.half_v);
    }
  }
}

Vec3f DirectLight::Irradiance(const Vec3f& position, const Vec3f& unit_normal) const {
  Vec3f sum;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const RectLight& light = scene_.lights[i];
    const auto open =
        float(RectangleFormFactor(light, position.Cast<double>(), unit_normal.Cast<double>()));
    if (open > 0) sum += (open * Visibility(i, position, unit_normal)) * light.radiance;
  }
  return sum;
}

float DirectLight::Visibility(std::size_t light, const Vec3f& position, const Vec3f& normal) const {
  const RectLight& rect = scene_.lights[light];
  const Vec3f facing = Cross(rect.half_u, rect.half_v);
  const Vec3f origin = position + kRayOffsetM * normal;
  const std::vector<Vec3f>& points = points_[light];
  float total = 0, visible = 0;
  for (std::size_t first = 0; first < points.size(); first += kPacketSize) {
    RayPacket rays;
    float weight[kPacketSize] = {};
    const int count = int(std::min<std::size_t>(kPacketSize, points.size() - first));
    for (int i = 0; i < count; ++i) {
      const Vec3f way = points[first + std::size_t(i)] - origin;
      const float cosines = Dot(way, normal) * -Dot(way, facing), r_sq = Dot(way, way);
      if (!(Dot(way, normal) > 0 && cosines > 0)) continue;
      weight[i] = cosines / (r_sq * r_sq);
      rays.Set(i, {origin, way, 0, kShadowEnd});
    }
    const std::uint32_t occluded = tracer_.Occluded(rays);
    for (int i = 0; i < count; ++i) {
      total += weight[i];
      if (!(occluded >> i & 1)) visible += weight[i];
    }
  }
  return total > 0 ? visible / total : 0;
}

}  // namespace silt::sim
