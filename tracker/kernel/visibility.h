// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/host_device.h"
#include "silt/tracker/kernel/scalar.h"
#include "silt/tracker/kernel/warp.h"

// What hides a point from the current camera: its own depth, or, without one, the other points of
// the keyframe.
namespace silt::tracker::kernel {

// A point hides others that are farther by more than this share of its depth: well above the slope
// of a surface over the few pixels looked at, well below the gap between two objects.
inline constexpr float kHidingMargin = 0.03f;

// The current pixel that a point lands in; (0, 0) where it is not in view.
template <typename T>
struct LandingPixel {
  T x, y;  // not yet rounded down
  Mask<T> inside;
};

template <typename T>
SILT_HOST_DEVICE inline LandingPixel<T> Land(const WarpedPixel<T>& warped, int width, int height) {
  const T u = warped.u + T(0.5f), v = warped.v + T(0.5f), zero(0.0f);
  const Mask<T> inside =
      warped.front && u >= zero && v >= zero && u < T(float(width)) && v < T(float(height));
  return {Select(inside, u, zero), Select(inside, v, zero), inside};
}

// Whether the current depth at its landing pixel, in metres, shows something in front of the point.
template <typename T>
SILT_HOST_DEVICE inline Mask<T> IsHidden(const WarpedPixel<T>& warped,
                                         const LandingPixel<T>& landing, const T& seen_m) {
  return landing.inside && seen_m > T(kMinDepth) && warped.point.z > T(1 + kHidingMargin) * seen_m;
}

// The current image in cells of 2×2 pixels: wide enough for no gap to open between the points of a
// surface that the camera comes closer to. A point is hidden by those in its own cell and the eight
// around it, 2 to 4 pixels on each side: the pose is not yet exact, and a residual beside an
// occluding edge mixes both surfaces.
inline constexpr int kCellPixels = 2;

struct CellGrid {
  int columns, rows;
};

SILT_HOST_DEVICE inline CellGrid CellsOf(int width, int height) {
  return {width / kCellPixels + 1, height / kCellPixels + 1};
}

// A reference pixel in the current image.
struct CellLanding {
  int cell = 0;
  float z = 0;  // in metres; 0: out of view
};

SILT_HOST_DEVICE inline CellLanding LandInCell(const WarpedPixel<float>& warped, int width,
                                               int height) {
  const bool in_view = warped.front && warped.u >= 0 && warped.v >= 0 && warped.u < float(width) &&
                       warped.v < float(height);
  if (!in_view) return {};
  const int column = int(warped.u) / kCellPixels, row = int(warped.v) / kCellPixels;
  return {row * CellsOf(width, height).columns + column, warped.point.z};
}

// Whether what is nearest in and around its cell, in metres, hides it.
SILT_HOST_DEVICE inline bool IsHidden(const CellLanding& landing, float nearest_m) {
  return nearest_m < (1 - kHidingMargin) * landing.z;
}

}  // namespace silt::tracker::kernel
