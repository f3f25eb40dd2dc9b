// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/camera.h"
#include "silt/core/image.h"
#include "silt/core/lens.h"

namespace silt::sim {

// The inverse of a lens over a camera's picture, one pixel beyond its border included.
class LensMap {
 public:
  // Throws silt::Error where the coefficients have no inverse in the picture.
  LensMap(const PinholeCamera& camera, const LensDistortion& lens);

  // The pixel at which the same camera without the lens sees what the lens shows at (u, v), both
  // within two pixels of the picture. Exact to rounding.
  Vec2d PinholePixel(double u, double v) const;

 private:
  Vec2d Distorted(double u, double v) const {
    return {(u - camera_.cx) / camera_.fx, (v - camera_.cy) / camera_.fy};
  }
  // The undistorted point of pixel (x, y), reached from that of a pixel next to it; not a number
  // beyond a fold.
  Vec2d Continue(int x, int y, const Vec2d& neighbour) const;
  // The same from the centre of distortion, in steps of a pixel.
  Vec2d Reach(int x, int y) const;
  void RequireUnfolded() const;
  Vec2d& At(int x, int y) { return centers_(x + 1, y + 1); }

  PinholeCamera camera_;
  LensDistortion lens_;
  Image<Vec2d> centers_;  // undistorted coordinates of the pixels (−1, −1) to (width, height)
};

}  // namespace silt::sim
