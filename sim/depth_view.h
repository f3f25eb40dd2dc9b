// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/sim/geometry_buffers.h"
#include "silt/sim/lens_map.h"

namespace silt::sim {

// What lies before a depth sensor: the true geometry, and the camera that sees it.
struct DepthView {
  const PinholeCamera& camera;
  const LensMap* lens;  // null: none
  const GeometryBuffers& truth;

  // cos θ of the angle between a pixel's ray and the normal of what it meets; 0 where there is
  // none.
  double CosIncidence(int x, int y) const;
  // Depth at a place between the pixels' centres (the picture's border continues), bilinear; 0
  // where a pixel that takes part has none.
  float BilinearDepth(double u, double v) const;
  // The same on one surface: where the four depths differ by more than 5 %, the nearest pixel's.
  float SurfaceDepth(double u, double v) const;
};

}  // namespace silt::sim
