// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// What the rays through the pixels' centres meet, never filtered. All of it is 0 where a ray meets
// nothing.
struct GeometryBuffers {
  Image<float> depth_m;        // along z
  Image<Vec3f> normal_camera;  // unit, of the triangle itself, on the side that is seen
  Image<std::uint32_t> instance, material;  // index in the scene + 1
};

}  // namespace silt::sim
