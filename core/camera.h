// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/vector.h"

namespace silt {

// Pinhole camera: x right, y down, z forward, fy > 0; pixel centres at integers.
//   u = fx·X/Z + cx,  v = fy·Y/Z + cy.
template <typename T>
struct Pinhole {
  T fx{}, fy{}, cx{}, cy{};
  int width = 0, height = 0;

  // Point in camera coordinates (Z ≠ 0) to pixels.
  SILT_HOST_DEVICE Vec2<T> Project(const Vec3<T>& p) const {
    return {fx * p.x / p.z + cx, fy * p.y / p.z + cy};
  }

  // Pixel and its depth along z to the point in camera coordinates.
  SILT_HOST_DEVICE Vec3<T> Unproject(const T& u, const T& v, const T& z) const {
    return {(u - cx) / fx * z, (v - cy) / fy * z, z};
  }

  // The camera of the next coarser pyramid level, whose pixel is the mean of a 2×2 block: its
  // centre (0, 0) lies at (½, ½) below, hence c' = (c + ½)/2 − ½. An odd last column or row drops.
  SILT_HOST_DEVICE Pinhole Halved() const {
    const T half(0.5);
    return {half * fx, half * fy, half * (cx + half) - half, half * (cy + half) - half,
            width / 2, height / 2};
  }

  template <typename U>
  SILT_HOST_DEVICE Pinhole<U> Cast() const {
    return {U(fx), U(fy), U(cx), U(cy), width, height};
  }
};

using PinholeCamera = Pinhole<double>;

// The camera of the ICL-NUIM and Handa sequences, with fy turned positive.
inline constexpr PinholeCamera kIclNuimCamera{481.2, 480.0, 319.5, 239.5, 640, 480};

}  // namespace silt
