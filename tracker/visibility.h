// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/se3.h"

namespace silt::tracker {

// The depths, in metres, of those pixels of a reference image whose points the current camera can
// see as far as the reference tells: a point that lies behind another one, or within a few pixels
// of being so, gets 0, no measurement. What the reference does not show cannot hide anything.
Image<float> VisibleDepth(const Image<float>& depth_m, const PinholeCamera& camera,
                          const SE3d& current_from_reference);

}  // namespace silt::tracker
