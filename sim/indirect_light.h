// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "silt/sim/ray_tracer.h"
#include "silt/sim/sampling.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

// Radiance that a surface sends along a ray that meets it, against the ray's unit direction.
using SurfaceRadiance = std::function<Vec3f(const TriangleHit& hit, const Vec3f& direction)>;

// What a hemisphere of rays has met.
struct Gathered {
  Vec3f irradiance;
  // Harmonic mean of the distances: light changes about as slowly along the surface as this is
  // long (Ward, Rubinstein, Clear 1988).
  float distance_m = 0;
  // Inside something: all rays end close by, or at backs. Nobody looks at this place.
  bool closed = false;
  // The same, or under something so near that samples farther apart than that cannot tell its
  // light.
  bool buried = false;
};

// Light that arrives from surfaces, and from a constant ambient where a direction meets none (that
// of an Environment is found otherwise, see EnvironmentLight):
// E = π/N Σ L(ω_i) over N directions with density cos θ / π, evenly spread by Vogel's spiral and
// turned about the normal by chance. Where they differ much, as a window's among walls does, more
// rounds of N directions follow, each with a turn of its own, until the mean is good enough.
class IndirectLight {
 public:
  struct Rounds {
    int most = 1;
    float tolerance = 0;  // standard error that is good enough, as a share of all the light
  };
  IndirectLight(const Scene& scene, const RayTracer& tracer, int directions, std::uint64_t seed,
                const Rounds& rounds = {1, 0});

  // `place` numbers the point: each has turns of its own. `known` is other light that falls there.
  Gathered Gather(const Vec3f& position, const Vec3f& unit_normal, std::uint64_t place,
                  const SurfaceRadiance& radiance, const Vec3f& known = {}) const;

 private:
  struct Sums;
  void AddPacket(const Vec3f& origin, const TangentFrame& frame, std::size_t first,
                 const SurfaceRadiance& radiance, Sums& sums) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  std::uint64_t seed_;
  Rounds rounds_;
  std::vector<Vec3f> directions_;  // about +z
};

}  // namespace silt::sim
