// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/triangle_corners.h"

#include <algorithm>

namespace silt::sim {

namespace {

Vec3f SafelyNormalized(const Vec3f& v, const Vec3f& otherwise) {
  const float norm = Norm(v);
  return norm > 1e-12f ? (1 / norm) * v : otherwise;
}

// A weight that is 0 but for rounding.
constexpr float kOnEdge = 1e-6f;

}  // namespace

TriangleCorners::TriangleCorners(const Mesh& mesh, const Triangle& triangle) {
  for (int i = 0; i < 3; ++i) position[i] = mesh.positions[triangle.vertex[i]];
  front = SafelyNormalized(Cross(position[1] - position[0], position[2] - position[0]), {0, 0, 1});
  for (int i = 0; i < 3; ++i) {
    const Vec3f n = SafelyNormalized(mesh.normals[triangle.vertex[i]], front);
    normal[i] = Dot(n, front) < 0 ? -n : n;  // models disagree about which side is out
  }
}

Vec3f TriangleCorners::Position(const Vec3f& w) const {
  return w.x * position[0] + w.y * position[1] + w.z * position[2];
}

Vec3f TriangleCorners::Normal(const Vec3f& w) const {
  return SafelyNormalized(w.x * normal[0] + w.y * normal[1] + w.z * normal[2], normal[0]);
}

Vec3f TriangleCorners::Inward(const Vec3f& weight) const {
  Vec3f sum;
  for (int i = 0; i < 3; ++i) {
    if ((&weight.x)[i] > kOnEdge) continue;
    const Vec3f& a = position[(i + 1) % 3];
    const Vec3f along = SafelyNormalized(position[(i + 2) % 3] - a, {});
    const Vec3f height = position[i] - a - Dot(position[i] - a, along) * along;
    const float length = Norm(height);
    if (length > 0) sum += (std::min(kInwardM, length / 3) / length) * height;
  }
  return sum;
}

}  // namespace silt::sim
