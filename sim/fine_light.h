// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/stored_light.h"
#include "silt/sim/surface_grid.h"

namespace silt::sim {

// Irradiance on single cells of a grid, at kPlaces evenly spread places each: where the grid's own
// samples are too far apart to tell it, at the edge of a shadow or where things touch.
class FineLight {
 public:
  static constexpr int kIntervals = 4;  // along either side of a cell
  static constexpr int kSide = kIntervals + 1, kPlaces = kSide * kSide;

  // One side of a cell, see SurfaceGrid::Cell.
  struct Patch {
    SurfaceGrid::Cell cell;
    std::uint32_t front = 1;  // 0: the back
    auto operator<=>(const Patch&) const = default;
  };

  FineLight() = default;
  // Sorted patches; kPlaces values for each, those along the cell's rows together.
  FineLight(std::vector<Patch> patches, std::vector<Vec3f> irradiance);

  const std::vector<Patch>& patches() const { return patches_; }
  const std::vector<Vec3f>& irradiance() const { return irradiance_; }

  // Nothing where that side of the cell has no patch.
  std::optional<Vec3f> At(const SurfaceGrid::CellPlace& place, bool front) const;

  // Of a place in a cell, the four of its kPlaces about it: `first`, the next one, and those kSide
  // after them.
  struct Corner {
    int first;
    float along, up;  // in [0, 1], from there
  };
  static Corner CornerOf(float along, float up) {
    const float x = along * kIntervals, y = up * kIntervals;
    const int column = x < kIntervals - 1 ? int(x) : kIntervals - 1;
    const int row = y < kIntervals - 1 ? int(y) : kIntervals - 1;
    return {row * kSide + column, x - float(column), y - float(row)};
  }

 private:
  std::vector<Patch> patches_;
  std::vector<Vec3f> irradiance_;
};

// All light on the surfaces of a scene.
struct BakedLight {
  StoredLight samples;
  FineLight fine;
};

}  // namespace silt::sim
