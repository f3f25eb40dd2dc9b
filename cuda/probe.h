// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"
#include "silt/tracker/kernel/sums.h"

// The tracker's kernels on the GPU, at points that the caller chooses: what a CUDA backend must
// agree with, and the proof that their one source compiles for a device.
namespace silt::cuda {

template <typename T>
struct ProbeInput {
  const Image<float>& current_intensity;
  PinholeCamera camera;
  SE3d current_from_reference;
  std::vector<tracker::kernel::ReferencePixel<T>> pixels;
};

template <typename T>
struct ProbeResult {
  std::vector<tracker::kernel::LinearizedResidual<T>> residuals;  // of each pixel
  tracker::kernel::Sums<T> sums;                                  // over them, in a fixed order
};

// For T = float and double. Throws silt::Error where there is no GPU or a call of CUDA's fails.
template <typename T>
ProbeResult<T> Probe(const ProbeInput<T>& input);

}  // namespace silt::cuda
