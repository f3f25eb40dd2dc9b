// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

// Light that arrives straight from a scene's rectangles. Each light's share is its exact form
// factor times the visible part of it, which a fixed grid of points tells: smooth where nothing is
// in between, and the same grid everywhere, so that soft shadows carry no noise. The grid's cells
// that the edge of a shadow crosses are looked at again, each with kEdge² points; and along the
// light's own border, where lamps have rims, what they hide is found by halving.
class DirectLight {
 public:
  // `points` along either side of a light; half as many where it could do no more than a lamp does.
  DirectLight(const Scene& scene, const RayTracer& tracer, int points);

  Vec3f Irradiance(const Vec3f& position, const Vec3f& unit_normal) const;

 private:
  static constexpr int kEdge = 4;

  struct View;  // of a light from a point

  // Share of the light that reaches the point, weighted by cos θ cos θ' / r².
  float Visibility(const View& view, int points) const;
  // Of one of the grid's cells, the part that does not.
  float HiddenShare(const View& view, int points, const Vec2<int>& cell) const;
  // Of each of the grid's cells, the part that a rim hides along the light's border. Cells whose
  // middle is hidden are left out.
  Image<float> RimShares(const View& view, const Image<char>& hidden) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  int points_;
};

}  // namespace silt::sim
