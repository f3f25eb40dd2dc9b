// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

// Light that arrives straight from a scene's rectangles. Each light's share is its exact form
// factor times the visible part of a fixed set of points on it: smooth where nothing is in between,
// and the same set everywhere, so that soft shadows carry no noise.
class DirectLight {
 public:
  DirectLight(const Scene& scene, const RayTracer& tracer, int points_per_light);

  Vec3f Irradiance(const Vec3f& position, const Vec3f& unit_normal) const;

 private:
  // Share of the light that reaches the point, weighted by cos θ cos θ' / r².
  float Visibility(std::size_t light, const Vec3f& position, const Vec3f& normal) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  std::vector<std::vector<Vec3f>> points_;  // per light
};

}  // namespace silt::sim
