// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "silt/sim/bounds.h"
#include "silt/sim/mesh.h"

namespace silt::sim {

// A triangle's corners in world coordinates, in double: for geometry that must tell micrometres.
using Corners = std::array<Vec3d, 3>;

Corners CornersOf(const Mesh& mesh, std::uint32_t triangle);
Bounds BoundsOf(const Mesh& mesh, std::uint32_t triangle);
// (b − a) × (c − a): twice the area, towards the front.
Vec3d AreaVector(const Corners& corners);
// The point of the triangle that is nearest to `point`.
Vec3d NearestPoint(const Corners& corners, const Vec3d& point);
// Whether the segment from p to q meets the triangle, from either side.
bool Pierces(const Vec3d& p, const Vec3d& q, const Corners& corners);

// Finds triangles by place: a tree of boxes over some of a mesh's triangles. The mesh must outlive
// it. Triangles whose corners are not finite are left out.
class TriangleTree {
 public:
  TriangleTree(const Mesh& mesh, std::vector<std::uint32_t> triangles);
  // Of all triangles.
  explicit TriangleTree(const Mesh& mesh);

  // Calls visit(triangle) for each triangle whose box touches `box`, in an order of the tree's own,
  // the same in every run. It stops when `visit` returns false.
  using Visitor = std::function<bool(std::uint32_t triangle)>;
  void Visit(const Bounds& box, const Visitor& visit) const;
  // The same for each triangle that the segment from p to q meets, from either side.
  void VisitPierced(const Vec3d& p, const Vec3d& q, const Visitor& visit) const;

 private:
  struct Node {
    Bounds bounds;
    // A leaf holds items [first, first + count); count 0: an inner node, whose children are the
    // next node and the one at `first`.
    std::uint32_t first = 0, count = 0;
  };
  struct Item {
    Bounds bounds;
    std::uint32_t triangle = 0;
  };

  std::uint32_t Build(std::uint32_t begin, std::uint32_t end);
  // Visits the items whose boxes, and those of their nodes, `meets` accepts.
  template <typename Meets>
  void VisitWhere(const Meets& meets, const Visitor& visit) const;

  const Mesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<Item> items_;
};

}  // namespace silt::sim
