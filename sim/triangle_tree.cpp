// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/triangle_tree.h"

#include <cmath>
#include <numeric>

namespace silt::sim {
namespace {

constexpr std::uint32_t kLeafSize = 6;

float Middle(const Bounds& b, int axis) {
  if (axis == 0) return b.low.x + b.high.x;
  return axis == 1 ? b.low.y + b.high.y : b.low.z + b.high.z;
}

int LongestAxis(const Vec3f& size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

bool IsFinite(const Mesh& mesh, std::uint32_t triangle) {
  double sum = 0;
  for (const std::uint32_t v : mesh.triangles[triangle].vertex) {
    const Vec3f& p = mesh.positions[v];
    sum += std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  }
  return std::isfinite(sum);
}

std::vector<std::uint32_t> AllTriangles(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

// A segment p + t·(q − p), 0 ≤ t ≤ 1, clipped by the slabs of a box.
class Segment {
 public:
  Segment(const Vec3d& p, const Vec3d& q)
      : from_(p), per_x_(1 / (q.x - p.x)), per_y_(1 / (q.y - p.y)), per_z_(1 / (q.z - p.z)) {}

  bool Meets(const Bounds& b) const {
    double low = -kSlack, high = 1 + kSlack;
    return Clip(b.low.x - from_.x, b.high.x - from_.x, per_x_, low, high) &&
           Clip(b.low.y - from_.y, b.high.y - from_.y, per_y_, low, high) &&
           Clip(b.low.z - from_.z, b.high.z - from_.z, per_z_, low, high);
  }

 private:
  static constexpr double kSlack = 1e-9;

  // Along an axis on which the segment does not move, `per` is infinite, and 0·∞ compares false.
  static bool Clip(double near, double far, double per, double& low, double& high) {
    const double a = near * per, b = far * per;
    low = std::max(low, std::min(a, b) - kSlack);
    high = std::min(high, std::max(a, b) + kSlack);
    return !(low > high);
  }

  Vec3d from_;
  double per_x_, per_y_, per_z_;
};

}  // namespace

Corners CornersOf(const Mesh& mesh, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return {mesh.positions[t.vertex[0]].Cast<double>(), mesh.positions[t.vertex[1]].Cast<double>(),
          mesh.positions[t.vertex[2]].Cast<double>()};
}

Bounds BoundsOf(const Mesh& mesh, std::uint32_t triangle) {
  Bounds bounds;
  for (const std::uint32_t v : mesh.triangles[triangle].vertex) bounds.Add(mesh.positions[v]);
  return bounds;
}

Vec3d AreaVector(const Corners& c) { return Cross(c[1] - c[0], c[2] - c[0]); }

// Ericson, Real-Time Collision Detection (2005), §5.1.5: which of the seven regions about the
// triangle the point lies over.
Vec3d NearestPoint(const Corners& corners, const Vec3d& p) {
  const auto& [a, b, c] = corners;
  const Vec3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = Dot(ab, ap), d2 = Dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = Dot(ab, bp), d4 = Dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const double d5 = Dot(ab, cp), d6 = Dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + ((d4 - d3) / (d4 - d3 + d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

// Möller and Trumbore: p + t·(q − p) = a + u·(b − a) + v·(c − a).
bool Pierces(const Vec3d& p, const Vec3d& q, const Corners& corners) {
  const Vec3d way = q - p;
  const Vec3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vec3d cross = Cross(way, ac);
  const double det = Dot(ab, cross);
  if (det == 0) return false;
  const Vec3d from = p - corners[0];
  const double u = Dot(from, cross) / det;
  const Vec3d other = Cross(from, ab);
  const double v = Dot(way, other) / det;
  const double t = Dot(ac, other) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

TriangleTree::TriangleTree(const Mesh& mesh) : TriangleTree(mesh, AllTriangles(mesh)) {}

TriangleTree::TriangleTree(const Mesh& mesh, std::vector<std::uint32_t> triangles) : mesh_(mesh) {
  items_.reserve(triangles.size());
  for (const std::uint32_t t : triangles) {
    if (IsFinite(mesh, t)) items_.push_back({BoundsOf(mesh, t), t});
  }
  if (!items_.empty()) Build(0, std::uint32_t(items_.size()));
}

// Halves at the median of the longest axis of the middles: balanced, hence no deeper than 32.
std::uint32_t TriangleTree::Build(std::uint32_t begin, std::uint32_t end) {
  const auto index = std::uint32_t(nodes_.size());
  nodes_.emplace_back();
  Bounds bounds, middles;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Bounds& b = items_[i].bounds;
    bounds.Add(b);
    middles.Add(Vec3f{Middle(b, 0), Middle(b, 1), Middle(b, 2)});
  }
  if (end - begin <= kLeafSize) {
    nodes_[index] = {bounds, begin, end - begin};
    return index;
  }
  const int axis = LongestAxis(middles.Size());
  const std::uint32_t half = begin + (end - begin) / 2;
  const auto before = [axis](const Item& a, const Item& b) {
    const float x = Middle(a.bounds, axis), y = Middle(b.bounds, axis);
    return x != y ? x < y : a.triangle < b.triangle;
  };
  std::nth_element(items_.begin() + begin, items_.begin() + half, items_.begin() + end, before);
  Build(begin, half);
  const std::uint32_t second = Build(half, end);
  nodes_[index] = {bounds, second, 0};
  return index;
}

template <typename Meets>
void TriangleTree::VisitWhere(const Meets& meets, const Visitor& visit) const {
  std::uint32_t stack[64];
  int depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (!meets(node.bounds)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (meets(items_[i].bounds) && !visit(items_[i].triangle)) return;
    }
  }
}

void TriangleTree::Visit(const Bounds& box, const Visitor& visit) const {
  VisitWhere([&](const Bounds& bounds) { return bounds.Overlaps(box); }, visit);
}

void TriangleTree::VisitPierced(const Vec3d& p, const Vec3d& q, const Visitor& visit) const {
  const Segment segment(p, q);
  VisitWhere([&](const Bounds& bounds) { return segment.Meets(bounds); },
             [&](std::uint32_t triangle) {
               return !Pierces(p, q, CornersOf(mesh_, triangle)) || visit(triangle);
             });
}

}  // namespace silt::sim
