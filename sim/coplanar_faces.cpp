// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/coplanar_faces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "silt/core/parallel.h"

namespace silt::sim {
namespace {

constexpr std::uint32_t kTile = 4096;  // triangles that one task looks at
constexpr double kLeastShare = 1e-3;   // of the smaller triangle
constexpr double kParallel = 0.999;    // cosine below which planes part at once

// A convex polygon of few corners; a triangle clipped by three edges has at most six.
struct Polygon {
  std::array<Vec3d, 8> corner;
  int count = 0;

  void Add(const Vec3d& p) {
    if (count < int(corner.size())) corner[std::size_t(count++)] = p;
  }
};

// The part of `from` on the inner side of the plane through `origin` (Sutherland and Hodgman).
Polygon Clipped(const Polygon& from, const Vec3d& origin, const Vec3d& inward) {
  Polygon to;
  for (int i = 0; i < from.count; ++i) {
    const Vec3d& a = from.corner[std::size_t(i)];
    const Vec3d& b = from.corner[std::size_t((i + 1) % from.count)];
    const double da = Dot(a - origin, inward), db = Dot(b - origin, inward);
    if (da >= 0) to.Add(a);
    if ((da < 0) != (db < 0)) to.Add(a + (da / (da - db)) * (b - a));
  }
  return to;
}

class OverlapFinder {
 public:
  OverlapFinder(const Mesh& mesh, const TriangleTree& tree) : mesh_(mesh), tree_(tree) {
    normals_.reserve(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3d area = AreaVector(CornersOf(mesh, t));
      const double length = Norm(area);
      normals_.push_back(length > 1e-30 ? ((1 / length) * area).Cast<float>() : Vec3f{});
    }
  }

  void FindFor(std::uint32_t first, std::vector<FaceOverlap>& found) const {
    const std::size_t before = found.size();
    const Vec3f& normal = normals_[first];
    if (Dot(normal, normal) == 0) return;
    const Corners corners = CornersOf(mesh_, first);
    tree_.Visit(BoundsOf(mesh_, first).Grown(float(kTieDistance_m)), [&](std::uint32_t second) {
      if (second <= first) return true;
      if (std::abs(Dot(normal, normals_[second])) < kParallel) return true;
      const FaceOverlap overlap = OverlapOf(first, second, corners);
      if (overlap.area_m2 > 0) found.push_back(overlap);
      return true;
    });
    std::sort(found.begin() + std::ptrdiff_t(before), found.end(),
              [](const FaceOverlap& a, const FaceOverlap& b) { return a.second < b.second; });
  }

 private:
  // The second triangle seen along the first one's normal and clipped by its three edges.
  FaceOverlap OverlapOf(std::uint32_t first, std::uint32_t second, const Corners& a) const {
    const Corners b = CornersOf(mesh_, second);
    const Vec3d normal = Normalized(AreaVector(a));
    Polygon polygon;
    for (const Vec3d& corner : b) polygon.Add(corner);
    for (std::size_t i = 0; i < 3 && polygon.count > 0; ++i) {
      polygon = Clipped(polygon, a[i], Cross(normal, a[(i + 1) % 3] - a[i]));
    }
    FaceOverlap overlap{first, second, 0, {}};
    Vec3d area, sum;
    for (int i = 0; i < polygon.count; ++i) {
      const Vec3d& p = polygon.corner[std::size_t(i)];
      if (!(std::abs(Dot(p - a[0], normal)) <= kTieDistance_m)) return overlap;
      const Vec3d& q = polygon.corner[std::size_t((i + 1) % polygon.count)];
      area += 0.5 * Cross(p - polygon.corner[0], q - polygon.corner[0]);
      sum += p;
    }
    const double smaller = 0.5 * std::min(Norm(AreaVector(a)), Norm(AreaVector(b)));
    if (!(Norm(area) > kLeastShare * smaller)) return overlap;
    overlap.area_m2 = Norm(area);
    overlap.middle = (1.0 / polygon.count) * sum;
    return overlap;
  }

  const Mesh& mesh_;
  const TriangleTree& tree_;
  std::vector<Vec3f> normals_;  // zero: the triangle has no area
};

}  // namespace

std::vector<FaceOverlap> FindOverlaps(const Mesh& mesh, const TriangleTree& tree) {
  const OverlapFinder finder(mesh, tree);
  const auto count = std::uint32_t(mesh.triangles.size());
  std::vector<std::vector<FaceOverlap>> tiles((count + kTile - 1) / kTile);
  ParallelFor(int(tiles.size()), [&](int tile) {
    const std::uint32_t begin = std::uint32_t(tile) * kTile;
    for (std::uint32_t t = begin; t < std::min(count, begin + kTile); ++t) {
      finder.FindFor(t, tiles[std::size_t(tile)]);
    }
  });
  std::vector<FaceOverlap> all;
  for (const auto& tile : tiles) all.insert(all.end(), tile.begin(), tile.end());
  return all;
}

}  // namespace silt::sim
