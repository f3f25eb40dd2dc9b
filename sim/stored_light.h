// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// A colour at each sample of a grid, on both sides; front is the side of the sample's normal.
struct StoredLight {
  std::vector<Vec3f> front, back;

  StoredLight() = default;
  StoredLight(std::vector<Vec3f> on_front, std::vector<Vec3f> on_back)
      : front(std::move(on_front)), back(std::move(on_back)) {}
  explicit StoredLight(std::size_t samples) : front(samples), back(samples) {}

  std::vector<Vec3f>& side(bool is_front) { return is_front ? front : back; }
  const std::vector<Vec3f>& side(bool is_front) const { return is_front ? front : back; }

  Vec3f At(const SurfaceLookup& at, bool is_front) const {
    const Vec3f* values = is_front ? front.data() : back.data();
    return at.weight[0] * values[at.sample[0]] + at.weight[1] * values[at.sample[1]] +
           at.weight[2] * values[at.sample[2]] + at.weight[3] * values[at.sample[3]];
  }
};

}  // namespace silt::sim
