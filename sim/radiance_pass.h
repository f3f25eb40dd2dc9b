// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"
#include "silt/sim/exposure_rays.h"
#include "silt/sim/lit_scene.h"

namespace silt::sim {

// Mean linear radiance over the samples of each pixel, by the light that is stored on surfaces.
Image<Vec3f> TraceRadiance(const LitScene& lit, const ExposureRays& rays);

}  // namespace silt::sim
