// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "silt/core/camera.h"
#include "silt/core/vector.h"

namespace silt {

// Brown-Conrady distortion with OpenCV's coefficients, on normalised coordinates (X/Z, Y/Z):
//   x_d = x·(1 + k1·r² + k2·r⁴ + k3·r⁶) + 2·p1·x·y + p2·(r² + 2·x²)
//   y_d = y·(1 + k1·r² + k2·r⁴ + k3·r⁶) + p1·(r² + 2·y²) + 2·p2·x·y,   r² = x² + y²,
// and the pixel is (fx·x_d + cx, fy·y_d + cy). All zero: a pinhole camera.
// Source: D. C. Brown, "Decentering distortion of lenses", 1966.
struct LensDistortion {
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

  constexpr bool operator==(const LensDistortion&) const = default;
  constexpr bool IsNone() const { return *this == LensDistortion{}; }

  template <typename T>
  Vec2<T> Distort(const Vec2<T>& p) const {
    const T r2 = p.x * p.x + p.y * p.y, xy2 = T(2) * p.x * p.y;
    const T radial = T(1) + r2 * (T(k1) + r2 * (T(k2) + r2 * T(k3)));
    return {p.x * radial + T(p1) * xy2 + T(p2) * (r2 + T(2) * p.x * p.x),
            p.y * radial + T(p1) * (r2 + T(2) * p.y * p.y) + T(p2) * xy2};
  }

  // ∂(x_d, y_d)/∂(x, y), which is symmetric.
  template <typename T>
  struct Derivative {
    T xx, xy, yy;
    T Determinant() const { return xx * yy - xy * xy; }
  };
  template <typename T>
  Derivative<T> DistortDerivative(const Vec2<T>& p) const {
    const T r2 = p.x * p.x + p.y * p.y;
    const T radial = T(1) + r2 * (T(k1) + r2 * (T(k2) + r2 * T(k3)));
    // d radial / d r², twice.
    const T slope = T(2) * (T(k1) + r2 * (T(2 * k2) + r2 * T(3 * k3)));
    const T a = T(2 * p1) * p.y, b = T(2 * p2) * p.x;
    return {radial + slope * p.x * p.x + a + T(3) * b,
            slope * p.x * p.y + T(2 * p1) * p.x + T(2 * p2) * p.y,
            radial + slope * p.y * p.y + T(3) * a + b};
  }

  // One step of Newton's method towards the p with Distort(p) = distorted.
  template <typename T>
  Vec2<T> NewtonStep(const Vec2<T>& p, const Vec2<T>& distorted) const {
    const Vec2<T> e = Distort(p) - distorted;
    const Derivative<T> d = DistortDerivative(p);
    const T scale = T(1) / d.Determinant();
    return {p.x - scale * (d.yy * e.x - d.xy * e.y), p.y - scale * (d.xx * e.y - d.xy * e.x)};
  }

  // The inverse of Distort, exact to rounding, where Newton's method gets there from `start`, a
  // point nearby; not finite or not the inverse where it does not: the picture may fold there.
  template <typename T>
  Vec2<T> Undistort(const Vec2<T>& distorted, const Vec2<T>& start) const {
    Vec2<T> p = start;
    for (int i = 0; i < 20; ++i) {
      const Vec2<T> next = NewtonStep(p, distorted);
      const T dx = next.x - p.x, dy = next.y - p.y;
      p = next;
      if (!(dx * dx + dy * dy > T(1e-20))) break;
    }
    // Quadratic convergence: from 1e-10 to the last bit, and to that of a derivative.
    return NewtonStep(p, distorted);
  }
  template <typename T>
  Vec2<T> Undistort(const Vec2<T>& distorted) const {
    return Undistort(distorted, distorted);
  }
};

// Where a camera with a lens sees a point in camera coordinates (Z ≠ 0), in pixels.
template <typename T>
Vec2<T> ProjectThroughLens(const Pinhole<T>& camera, const LensDistortion& lens, const Vec3<T>& p) {
  const Vec2<T> d = lens.Distort(Vec2<T>{p.x / p.z, p.y / p.z});
  return {camera.fx * d.x + camera.cx, camera.fy * d.y + camera.cy};
}

}  // namespace silt
