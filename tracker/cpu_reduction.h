// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/normal_equations.h"
#include "silt/tracker/options.h"
#include "silt/tracker/residual_norm.h"
#include "silt/tracker/simd/kernels.h"
#include "silt/tracker/simd_level.h"

namespace silt::tracker {

// One level of a pair of images, all of the camera's size.
struct LevelImages {
  const PinholeCamera& camera;
  const Image<float>& reference_intensity;
  const Image<float>& reference_depth_m;
  const Image<float>& current_intensity;
  const Image<float>* current_depth_m = nullptr;
  const Image<float>* current_inverse_depth = nullptr;  // for residuals of it
  // Of the current intensity, which is one of coefficients for a B-spline.
  Interpolant interpolant = Interpolant::kBilinear;
};

// The sums over a level's pixels by one instruction set.
class CpuReduction {
 public:
  explicit CpuReduction(SimdLevel level);

  PhotometricCost Cost(const LevelImages& images, const SE3d& current_from_reference) const;
  NormalEquations Equations(const LevelImages& images, const SE3d& current_from_reference,
                            const ResidualNorm& norm = {}) const;
  // The reference's depth without what is hidden from the current camera, as its depth tells.
  void CopyVisibleDepth(const LevelImages& images, const SE3d& current_from_reference,
                        Image<float>* visible_m) const;

 private:
  simd::Kernels kernels_;
};

}  // namespace silt::tracker
