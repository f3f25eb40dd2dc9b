// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/image.h"

namespace silt::experiments {

// The cubic B-spline through the values of an image: f(x) = Σ c_i β(x − i) along each axis. Nearer
// to what a band-limited image is between its pixels than any polynomial of so few neighbours
// (Thévenaz, Blu, Unser 2000), since c depends on the whole row and column.
class SplineImage {
 public:
  // At least 2 × 2; continued by reflection at its borders.
  explicit SplineImage(const Image<float>& values);

  // (u, v) in pixels, at least one from the border.
  double At(double u, double v) const;

 private:
  Image<double> coefficients_;
};

}  // namespace silt::experiments
