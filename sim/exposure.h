// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// How bright pictures are: radiance × exposure = 1 is white.
struct Exposure {
  enum class Kind {
    kScene,     // as the scene file says
    kGiven,     // `value`
    kPerFrame,  // metered in each frame: what a camera on automatic does, and what breaks the
                // assumption that a surface keeps its brightness
  };
  Kind kind = Kind::kScene;
  double value = 1;
};

// The exposure that brings pictures, taken together, to a middle gray of 0.18 (geometric mean of
// luminance; pixels without light do not count), but lets no more than one pixel in fifty turn
// white. 1 where there is no light at all.
double MeteredExposure(const std::vector<Image<Vec3f>>& radiance);

}  // namespace silt::sim
