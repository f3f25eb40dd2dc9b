// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "silt/core/vector.h"
#include "silt/sim/mesh.h"

namespace silt::sim {

// A point on the surface at which light is stored. `position` is pulled a millimetre inwards on
// the rim of a surface, out of the wall that it may touch there.
struct SurfaceSample {
  Vec3f position, normal;         // unit shading normal, on the front side of the triangles
  bool on_wide_triangle = false;  // on one with several rows
};

// Where a value is looked up: Σ weight·value(sample).
struct SurfaceLookup {
  std::uint32_t sample[4];
  float weight[4];
};

// Mesh colours (Yuksel, Keyser, House 2010) with rows: a triangle whose edges exceed the spacing
// carries rows of samples parallel to its longest edge (to its shortest, if it is much longer than
// thick), as many in each row as its length asks for; values are interpolated along the two nearest
// rows, then between them. A smaller triangle carries its corners. Samples of equal position and
// normal are one, so that values continue from triangle to triangle.
class SurfaceGrid {
 public:
  SurfaceGrid(const Mesh& mesh, float spacing_m);

  const std::vector<SurfaceSample>& samples() const { return samples_; }

  // The point (1 − u − v)·p0 + u·p1 + v·p2 of a triangle.
  SurfaceLookup Locate(std::uint32_t triangle, float u, float v) const;

  // How the samples of a triangle lie: rows 0 … count parallel to one of its edges, row r at the
  // share r/count of the way to the corner `apex`, of Intervals(r) equal intervals from corner
  // apex + 1 to apex + 2 (mod 3). count 0: only at the corners.
  struct TriangleRows {
    int count = 0, apex = 0;
    const std::uint32_t* begin = nullptr;

    int Intervals(int row) const { return int(begin[row + 1] - begin[row]) - 1; }
  };
  TriangleRows RowsOf(std::uint32_t triangle) const {
    const std::uint32_t grid = triangles_[triangle].grid;
    if (grid == kNoGrid) return {};
    return {grids_[grid].count, grids_[grid].apex, &row_begin_[grids_[grid].first_row]};
  }

  // The same with a row from corner 1 to corner 2 for a triangle with samples at its corners alone.
  TriangleRows CellRowsOf(std::uint32_t triangle) const;

  // The sample at a row's column of those.
  std::uint32_t SampleAt(std::uint32_t triangle, int row, int column) const;

  // What lies between two rows of a triangle and two neighbours of the lower one: from the share
  // column/intervals of the way along both rows to (column + 1)/intervals, intervals being those of
  // the lower row. Cells tile the triangle.
  struct Cell {
    std::uint32_t triangle;
    std::uint16_t row, column;
    auto operator<=>(const Cell&) const = default;
  };
  // In a cell; along its rows and from one to the next, in [0, 1].
  struct CellPlace {
    Cell cell;
    float along, up;
  };
  CellPlace CellAt(std::uint32_t triangle, float u, float v) const;
  Vec2f PointOf(const CellPlace& place) const;  // its u, v

  // A triangle on which each sample lies, and where: what is known there can be had for a sample.
  struct Origin {
    std::uint32_t triangle;
    float u, v;
  };
  const std::vector<Origin>& origins() const { return origins_; }

 private:
  friend class SurfaceGridBuilder;

  static constexpr std::uint32_t kNoGrid = 0xffffffffu;
  struct TriangleSamples {
    std::uint32_t corner[3];
    std::uint32_t grid = kNoGrid;  // index into grids_
  };
  struct Rows {
    std::uint32_t first_row;  // index into row_begin_, which has count + 2 entries for it
    std::uint16_t count;      // the apex is row `count`
    std::uint16_t apex;       // corner opposite to the rows' edge
  };

  std::vector<SurfaceSample> samples_;
  std::vector<Origin> origins_;
  std::vector<TriangleSamples> triangles_;
  std::vector<Rows> grids_;
  std::vector<std::uint32_t> row_begin_;    // into row_samples_
  std::vector<std::uint32_t> row_samples_;  // sample numbers
};

}  // namespace silt::sim
