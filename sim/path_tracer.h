// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "silt/sim/emitters.h"
#include "silt/sim/path_sampler.h"
#include "silt/sim/ray_tracer.h"
#include "silt/sim/surface_point.h"

namespace silt::sim {

// How light that comes straight from an emitter is found: by aiming at it, by meeting it after a
// reflection, or by both, each weighted by its density (Veach 1997, balance heuristic).
enum class LightStrategy { kBoth, kAim, kMeet };

struct PathOptions {
  LightStrategy strategy = LightStrategy::kBoth;
  bool reflection = true;  // materials reflect as they say; false: all surfaces are matt
  bool roulette = true;    // end paths by chance once they carry little, and count the others more
  int most_bounces = 1000;

  // Irradiance on a side of a surface where it is known already: what is matt is taken from there,
  // and only what reflects is followed further.
  std::function<Vec3f(const TriangleHit&)> known_irradiance = nullptr;
};

// Estimates the radiance along rays by random paths from the viewer, exact in the mean: it
// aims at every emitter from the first vertex, unless they are many, and at one from the others,
// and reflects in a direction drawn from the Bsdf. Scene and tracer must outlive it.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const RayTracer& tracer, PathOptions options = {});

  using Samplers = PathSampler[kPacketSize];
  using Radiances = Vec3f[kPacketSize];

  // One path for each valid ray: what arrives at its origin, from surfaces and background.
  void Trace(const RayPacket& rays, Samplers& samplers, Radiances& radiance) const;

  // What the surface at `hit` reflects as coat, metal or mirror, its matt ground left out, against
  // a ray of that (unit) direction: one path for each sampler.
  void TraceReflection(const TriangleHit& hit, const Vec3f& direction, Samplers& samplers,
                       Radiances& radiance) const;

  const PathOptions& options() const { return options_; }

 private:
  struct Paths;

  void Run(Paths& paths, Samplers& samplers, int bounce) const;
  void Scatter(Paths& paths, Samplers& samplers, int bounce) const;
  void Meet(Paths& paths, const HitPacket& hits, int lane) const;
  void Leave(Paths& paths, int lane) const;
  void Aim(Paths& paths, PathSampler& sampler, int lane, std::size_t emitter) const;
  void Reflect(Paths& paths, PathSampler& sampler, int lane, int bounce) const;

  const Scene& scene_;
  const RayTracer& tracer_;
  PathOptions options_;
  Emitters emitters_;
};

}  // namespace silt::sim
