// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/normal_equations.h"

namespace silt::tracker {

// One level of a pair of images, all of the camera's size.
struct LevelImages {
  const PinholeCamera& camera;
  const Image<float>& reference_intensity;
  const Image<float>& reference_depth_m;
  const Image<float>& current_intensity;
};

// Sums over the pixels of a level in single precision, rows added in double precision and in order.
PhotometricCost ReduceCost(const LevelImages& images, const SE3d& current_from_reference);
NormalEquations ReduceEquations(const LevelImages& images, const SE3d& current_from_reference);

}  // namespace silt::tracker
