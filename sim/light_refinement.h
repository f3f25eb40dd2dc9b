// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "silt/sim/cell_light.h"
#include "silt/sim/direct_light.h"
#include "silt/sim/environment_light.h"
#include "silt/sim/lighting_options.h"

namespace silt::sim {

// Finds the cells of a grid in which direct light bends so much that its samples do not tell it,
// and what falls at finer places there. Indirect light, which bends less, is that of the samples;
// surfaces that reflect nothing stay as they are. What is refined is the same for every thread
// count and run.
class LightRefinement {
 public:
  LightRefinement(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                  const LightingOptions& options);

  // `progress` is called with the share that is done.
  FineLight Refine(const LightSamples& samples, const std::function<void(double)>& progress) const;

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

  std::vector<Strip> LitStrips() const;
  void RefineStrip(const Strip& strip, const LightSamples& samples, Patches& result) const;
  // Whether a cell may hide something between its samples: they differ, or things are close.
  bool IsSuspect(const SurfaceGrid::Cell& cell, bool front, const LightSamples& samples) const;
  Vec3f Direct(const SurfaceSample& at) const;
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
