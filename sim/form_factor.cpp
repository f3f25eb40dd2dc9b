// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/form_factor.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

namespace {

// A quadrilateral that one plane has cut: at most five corners.
struct Polygon {
  Vec3d corner[5];
  int size = 0;
  void Add(const Vec3d& p) { corner[size++] = p; }
};

// The part with n·p ≥ 0 (Sutherland and Hodgman), with points relative to the receiver.
Polygon AboveHorizon(const Vec3d (&quad)[4], const Vec3d& normal) {
  Polygon result;
  for (int i = 0; i < 4; ++i) {
    const Vec3d &a = quad[i], &b = quad[(i + 1) % 4];
    const double height_a = Dot(a, normal), height_b = Dot(b, normal);
    if (height_a >= 0) result.Add(a);
    if ((height_a >= 0) != (height_b >= 0)) {
      result.Add(a + height_a / (height_a - height_b) * (b - a));
    }
  }
  return result;
}

}  // namespace

double RectangleFormFactor(const RectLight& light, const Vec3d& point, const Vec3d& normal) {
  const Vec3d center = light.center.Cast<double>() - point;
  const Vec3d u = light.half_u.Cast<double>(), v = light.half_v.Cast<double>();
  if (Dot(Cross(u, v), center) >= 0) return 0;  // the point is behind the light
  const Vec3d quad[4] = {center - u - v, center - u + v, center + u + v, center + u - v};
  const Polygon polygon = AboveHorizon(quad, normal);
  double sum = 0;
  for (int i = 0; i < polygon.size; ++i) {
    const Vec3d &a = polygon.corner[i], &b = polygon.corner[(i + 1) % polygon.size];
    const Vec3d cross = Cross(a, b);
    const double sine = Norm(cross);
    if (sine > 0) sum += std::atan2(sine, Dot(a, b)) * Dot(cross, normal) / sine;
  }
  return std::max(0.0, sum / 2);
}

}  // namespace silt::sim
