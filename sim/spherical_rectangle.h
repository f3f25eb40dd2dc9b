// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/vector.h"
#include "silt/sim/scene.h"

namespace silt::sim {

// A rectangle as a point sees it, on the unit sphere about that point, from which directions are
// drawn evenly (Ureña, Fajardo, King 2013, "An area-preserving parametrization for spherical
// rectangles"). Neighbours in the unit square stay neighbours.
class SphericalRectangle {
 public:
  // The sides of the rectangle are at right angles.
  SphericalRectangle(const RectLight& rectangle, const Vec3f& viewpoint);

  // Steradians; either side is seen alike. 0 if it is seen edge-on, or too small to be drawn from.
  double solid_angle() const { return solid_angle_; }

  // From the viewpoint to a point of the rectangle, for a point of [0, 1)².
  Vec3f WayTo(const Vec2f& square) const;

  static bool IsPossible(const RectLight& rectangle);

 private:
  Vec3d x_, y_, z_;                 // the rectangle's axes; z away from the viewpoint's side
  double x0_, x1_, y0_, y1_, z0_;   // its sides and plane in them, from the viewpoint
  double b0_ = 0, b1_ = 0, k_ = 0;  // of the inverse of the area's function, as in the paper
  double solid_angle_ = 0;
};

}  // namespace silt::sim
