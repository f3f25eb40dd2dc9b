// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_grid.h"

#include <algorithm>
#include <cmath>

#include "silt/sim/surface_grid_builder.h"

namespace silt::sim {

SurfaceGrid::SurfaceGrid(const Mesh& mesh, float spacing_m) {
  SurfaceGridBuilder(mesh, spacing_m, *this).Build();
}

SurfaceLookup SurfaceGrid::Locate(std::uint32_t triangle, float u, float v) const {
  const TriangleSamples& t = triangles_[triangle];
  if (t.grid == kNoGrid) {
    return {{t.corner[0], t.corner[1], t.corner[2], t.corner[0]}, {1 - u - v, u, v, 0}};
  }
  const Rows& rows = grids_[t.grid];
  const float weight[3] = {1 - u - v, u, v};
  const float base = weight[(rows.apex + 1) % 3], next = weight[(rows.apex + 2) % 3];
  const float along = base + next > 0 ? std::clamp(next / (base + next), 0.0f, 1.0f) : 0.0f;
  const float height = std::clamp(weight[rows.apex], 0.0f, 1.0f) * float(rows.count);
  const int row = std::min(int(height), int(rows.count) - 1);
  const float up = height - float(row);

  SurfaceLookup lookup;
  for (int i = 0; i < 2; ++i) {
    const std::uint32_t* begin = &row_begin_[rows.first_row + std::uint32_t(row + i)];
    const int intervals = int(begin[1] - begin[0]) - 1;  // 0 at the apex
    const float x = along * float(intervals);
    const int column = std::max(0, std::min(int(x), intervals - 1));
    const float right = x - float(column), share = i == 0 ? 1 - up : up;
    lookup.sample[2 * i] = row_samples_[begin[0] + std::uint32_t(column)];
    lookup.sample[2 * i + 1] =
        row_samples_[begin[0] + std::uint32_t(std::min(column + 1, intervals))];
    lookup.weight[2 * i] = share * (1 - right);
    lookup.weight[2 * i + 1] = share * right;
  }
  return lookup;
}

SurfaceGrid::TriangleRows SurfaceGrid::CellRowsOf(std::uint32_t triangle) const {
  static constexpr std::uint32_t kCorners[] = {0, 2, 3};
  const TriangleRows rows = RowsOf(triangle);
  return rows.count > 0 ? rows : TriangleRows{1, 0, kCorners};
}

std::uint32_t SurfaceGrid::SampleAt(std::uint32_t triangle, int row, int column) const {
  const TriangleSamples& t = triangles_[triangle];
  if (t.grid == kNoGrid) return t.corner[row == 0 ? 1 + column : 0];
  return row_samples_[row_begin_[grids_[t.grid].first_row + std::uint32_t(row)] +
                      std::uint32_t(column)];
}

SurfaceGrid::CellPlace SurfaceGrid::CellAt(std::uint32_t triangle, float u, float v) const {
  const TriangleRows rows = CellRowsOf(triangle);
  const float weight[3] = {1 - u - v, u, v};
  const float base = weight[(rows.apex + 1) % 3], next = weight[(rows.apex + 2) % 3];
  const float along = base + next > 0 ? std::clamp(next / (base + next), 0.0f, 1.0f) : 0.0f;
  const float height = std::clamp(weight[rows.apex], 0.0f, 1.0f) * float(rows.count);
  const int row = std::min(int(height), rows.count - 1);
  const int intervals = rows.Intervals(row);
  const float x = along * float(intervals);
  const int column = std::min(int(x), intervals - 1);
  return {{triangle, std::uint16_t(row), std::uint16_t(column)},
          x - float(column),
          height - float(row)};
}

Vec2f SurfaceGrid::PointOf(const CellPlace& place) const {
  const TriangleRows rows = CellRowsOf(place.cell.triangle);
  const float up = (float(place.cell.row) + place.up) / float(rows.count);
  const float along =
      (float(place.cell.column) + place.along) / float(rows.Intervals(place.cell.row));
  float weight[3];
  weight[rows.apex] = up;
  weight[(rows.apex + 1) % 3] = (1 - up) * (1 - along);
  weight[(rows.apex + 2) % 3] = (1 - up) * along;
  return {weight[1], weight[2]};
}

}  // namespace silt::sim
