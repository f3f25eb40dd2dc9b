// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"

namespace silt::tracker {

// Of the reference's measured pixels, the share whose points lie in the current camera's picture,
// hidden ones too; from 0 to 1, and 0 where nothing is measured. Pixels are taken from a grid, one
// of 16 in either direction, so that it costs next to nothing.
double ViewOverlap(const Image<float>& depth_m, const PinholeCamera& camera,
                   const SE3d& current_from_reference);

}  // namespace silt::tracker
