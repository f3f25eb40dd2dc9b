// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/vector.h"
#include "silt/sim/lens_map.h"

namespace silt::sim {

// The light that reaches a pixel, as a share of that at the centre:
//   cos⁴θ · (1 + a1·r² + a2·r⁴ + a3·r⁶),
// θ the angle of the ray to the optical axis (the natural fall-off of a thin lens), r the pixel's
// distance from the principal point in half diagonals of the picture (lensfun's model "pa").
struct Vignetting {
  bool cos4 = false;
  double a1 = 0, a2 = 0, a3 = 0;

  bool IsNone() const { return !cos4 && a1 == 0 && a2 == 0 && a3 == 0; }
};

// The share of every pixel's centre, seen through the lens where there is one. Throws silt::Error
// where the polynomial leaves (0, 1.0001] within the picture: a lens gives no light.
Image<float> VignettingShares(const Vignetting& vignetting, const PinholeCamera& camera,
                              const LensMap* lens);

}  // namespace silt::sim
