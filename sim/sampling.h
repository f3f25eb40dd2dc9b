// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "silt/core/vector.h"

namespace silt::sim {

// Fixed low-discrepancy point sets: every pixel, frame and surface point uses the same ones, so
// that pictures carry no noise. Each is centred: the mean of its points is exactly the middle.

// n points in [0, 1)²; n = 2^m stratifies every elementary interval, a (0, m, 2)-net in base 2.
std::vector<Vec2d> SquareSamples(int n);

// The second dimension of Sobol's sequence, as a fraction of 2³²; the first is the radical inverse.
std::uint32_t Sobol2(std::uint32_t k);

// n unit directions about +z whose density is cos θ / π.
std::vector<Vec3f> CosineDirections(int n);

// A right-handed frame whose third axis is the unit vector n (Duff et al. 2017).
struct TangentFrame {
  Vec3f tangent, bitangent, normal;
  explicit TangentFrame(const Vec3f& n);
  Vec3f World(const Vec3f& local) const {
    return local.x * tangent + local.y * bitangent + local.z * normal;
  }
};

}  // namespace silt::sim
