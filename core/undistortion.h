// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/lens.h"

namespace silt {

// Turns frames seen through a lens into those of a pinhole camera with the same intrinsics, for
// trackers that know no other. What lies outside the picture seen becomes black, without depth.
class Undistortion {
 public:
  Undistortion(const PinholeCamera& camera, const LensDistortion& lens);

  // Colours are interpolated between pixels as they are encoded; depth is, on one surface, and else
  // that of the nearest pixel. Throws silt::Error where the size is not the camera's.
  Frame Apply(const Frame& frame) const;

 private:
  Image<Vec2f> sources_;  // where each pixel is seen in the distorted picture
};

}  // namespace silt
