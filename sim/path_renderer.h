// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "silt/core/image.h"
#include "silt/sim/path_tracer.h"

namespace silt::sim {

struct PathPicture {
  int width = 0, height = 0;
  int samples_per_pixel = 1;
  std::uint64_t seed = 0;
  std::uint32_t frame = 0;  // number of the picture: each has random numbers of its own
};

// Sample k of a block of 4 × 4 pixels whose upper left one is (x, y), see CameraRays::Fill.
using RaysOfSample = std::function<void(int k, int x, int y, RayPacket& rays)>;

// Mean radiance of each pixel's samples, which count alike, one path each. Random numbers follow
// from (seed, frame, pixel): the picture is the same for any number of threads.
Image<Vec3f> RenderPaths(const PathTracer& tracer, const PathPicture& picture,
                         const RaysOfSample& rays_of_sample);

}  // namespace silt::sim
