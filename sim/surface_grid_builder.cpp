// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/surface_grid_builder.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

namespace {

constexpr float kMostIntervals = 1024;  // of a side, so that wide open ground stays finite
constexpr int kRowsOfWide = 3;
constexpr float kLong = 4;            // length to thickness
constexpr float kLengthwise = 2;      // spacings between the rows of a sliver
constexpr float kLeastAcross = 0.4f;  // of the spacing: wider, there is a sample between the edges

Vec3f SafelyNormalized(const Vec3f& v, const Vec3f& otherwise) {
  const float norm = Norm(v);
  return norm > 1e-12f ? (1 / norm) * v : otherwise;
}

int Intervals(float length_m, float spacing_m) {
  return int(std::clamp(std::ceil(length_m / spacing_m), 1.0f, kMostIntervals));
}

}  // namespace

void SurfaceGridBuilder::Build() {
  grid_.triangles_.reserve(mesh_.triangles.size());
  for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
    const TriangleCorners corners(mesh_, mesh_.triangles[i]);
    const Vec3f(&p)[3] = corners.position;
    const float longest = std::max({Norm(p[1] - p[0]), Norm(p[2] - p[1]), Norm(p[0] - p[2])});
    SurfaceGrid::TriangleSamples& samples = grid_.triangles_.emplace_back();
    samples.corner[0] = Sample(i, corners, {1, 0, 0});
    samples.corner[1] = Sample(i, corners, {0, 1, 0});
    samples.corner[2] = Sample(i, corners, {0, 0, 1});
    if (longest > spacing_m_) LayRows(i, corners);
  }
  PullInwards();
}

void SurfaceGridBuilder::LayRows(std::uint32_t triangle, const TriangleCorners& corners) {
  const Vec3f(&p)[3] = corners.position;
  const auto edge = [&](int apex) { return Norm(p[(apex + 2) % 3] - p[(apex + 1) % 3]); };
  int longest = 0, shortest = 0;
  for (int i = 1; i < 3; ++i) {
    if (edge(i) > edge(longest)) longest = i;
    if (edge(i) < edge(shortest)) shortest = i;
  }
  const float thickness = Norm(Cross(p[1] - p[0], p[2] - p[0])) / edge(longest);
  // Of a long triangle, rows go across, from one long edge to the other. Lookups between rows go
  // lengthwise, where light changes less.
  const bool is_long = edge(longest) > kLong * thickness;
  const int apex = is_long ? shortest : longest;
  const float base = edge(apex), side = std::max(edge((apex + 1) % 3), edge((apex + 2) % 3));
  const float between_rows = thickness < spacing_m_ ? kLengthwise * spacing_m_ : spacing_m_;
  const int count = Intervals(is_long ? side : thickness, between_rows);
  const int least = base > kLeastAcross * spacing_m_ ? 2 : 1;
  const int columns = std::max(least, Intervals(base, spacing_m_));

  grid_.triangles_[triangle].grid = std::uint32_t(grid_.grids_.size());
  grid_.grids_.push_back(
      {std::uint32_t(grid_.row_begin_.size()), std::uint16_t(count), std::uint16_t(apex)});
  for (int row = 0; row <= count; ++row) {
    grid_.row_begin_.push_back(std::uint32_t(grid_.row_samples_.size()));
    const float up = float(row) / float(count);
    const int intervals = row == count ? 0 : std::max(1, int(std::ceil(columns * (1 - up))));
    for (int column = 0; column <= intervals; ++column) {
      const float along = intervals == 0 ? 0 : float(column) / float(intervals);
      float weight[3];
      weight[apex] = up;
      weight[(apex + 1) % 3] = (1 - up) * (1 - along);
      weight[(apex + 2) % 3] = (1 - up) * along;
      const std::uint32_t sample = Sample(triangle, corners, {weight[0], weight[1], weight[2]});
      if (thickness >= kRowsOfWide * spacing_m_) grid_.samples_[sample].on_wide_triangle = true;
      grid_.row_samples_.push_back(sample);
    }
  }
  grid_.row_begin_.push_back(std::uint32_t(grid_.row_samples_.size()));
}

std::uint32_t SurfaceGridBuilder::Sample(std::uint32_t triangle, const TriangleCorners& c,
                                         const Vec3f& w) {
  const Vec3f position = c.Position(w), normal = c.Normal(w);
  const auto cell = [](float x, float scale) {
    const float scaled = std::clamp(x * scale, -2e9f, 2e9f);
    return std::int32_t(scaled + (scaled < 0 ? -0.5f : 0.5f));
  };
  // Position to 1/16 mm and normal to 1/32.
  const SampleIndex::Key key{cell(position.x, 16e3f), cell(position.y, 16e3f),
                             cell(position.z, 16e3f), cell(normal.x, 32),
                             cell(normal.y, 32),      cell(normal.z, 32)};
  const bool rim = w.x <= 0 || w.y <= 0 || w.z <= 0;
  // What lies within a triangle is no other's.
  const std::uint32_t number = rim ? known_.NumberOf(key) : known_.NewNumber();
  if (number == grid_.samples_.size()) {
    grid_.samples_.push_back({position, normal});
    grid_.origins_.push_back({triangle, w.y, w.z});
    rims_.push_back({});
  }
  if (rim) {
    rims_[number].inward += c.Inward(w);
    rims_[number].front += c.front;
  }
  return number;
}

void SurfaceGridBuilder::PullInwards() {
  for (std::size_t i = 0; i < rims_.size(); ++i) {
    SurfaceSample& sample = grid_.samples_[i];
    // Along the surface only: off it, the point would leave a convex solid's skin. The triangles
    // tell where that runs; shading normals are not always theirs.
    const Vec3f front = SafelyNormalized(rims_[i].front, sample.normal);
    const Vec3f way = rims_[i].inward - Dot(rims_[i].inward, front) * front;
    const float length = Norm(way);
    if (length > 0) sample.position += (std::min(1.0f, TriangleCorners::kInwardM / length)) * way;
  }
}

}  // namespace silt::sim
