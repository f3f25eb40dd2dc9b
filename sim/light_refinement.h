// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "silt/sim/direct_light.h"
#include "silt/sim/environment_light.h"
#include "silt/sim/fine_light.h"
#include "silt/sim/indirect_light.h"
#include "silt/sim/lighting_options.h"
#include "silt/sim/stored_light.h"

namespace silt::sim {

// Finds the cells of a grid in which direct light bends so much that its samples do not tell it,
// and what falls at finer places there. Indirect light, which bends less, is that of the samples.
// All of it is the same for every seed, thread count and run.
class LightRefinement {
 public:
  // What is known at the samples. `near` by side (front: 1): what each sees about itself.
  struct Samples {
    const StoredLight& direct;
    const StoredLight& indirect;
    const std::vector<Gathered> (&near)[2];
  };
  LightRefinement(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                  const LightingOptions& options);

  // `progress` is called with the share that is done.
  FineLight Refine(const Samples& samples, const std::function<void(double)>& progress) const;

 private:
  struct Strip {  // the cells of a side between two rows of a triangle
    std::uint32_t triangle;
    int row;
    bool front;
  };
  struct Patches {
    std::vector<FineLight::Patch> patches;
    std::vector<Vec3f> irradiance;
  };
  class CellLight;  // direct light at the places of a cell, found when asked for

  std::vector<Strip> LitStrips() const;
  void RefineStrip(const Strip& strip, const Samples& samples, Patches& result) const;
  // Whether a cell may hide something between its samples: they differ, or things are close.
  bool IsSuspect(const SurfaceGrid::Cell& cell, bool front, const Samples& samples) const;
  // Of the cell's longer diagonal.
  float LengthM(const SurfaceGrid::Cell& cell) const;

  const Scene& scene_;
  const SurfaceGrid& grid_;
  float tolerance_;
  DirectLight direct_;
  EnvironmentLight background_;
  IndirectLight look_;
};

}  // namespace silt::sim
