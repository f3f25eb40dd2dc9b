// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/feature_point.h"

#include <algorithm>
#include <cmath>

#include "silt/core/pyramid.h"

namespace silt::tracker {

std::optional<Vec3d> FeaturePoint(const Image<float>& depth_m, const PinholeCamera& camera,
                                  const Vec2d& pixel, double same_surface) {
  const double x0 = std::floor(pixel.x), y0 = std::floor(pixel.y);
  if (!(x0 >= 0 && y0 >= 0 && x0 < depth_m.width() && y0 < depth_m.height())) return {};
  const int x = int(x0), y = int(y0);
  // On the last column or row the neighbour beyond has weight 0.
  const int right = std::min(x + 1, depth_m.width() - 1);
  const int below = std::min(y + 1, depth_m.height() - 1);
  const float z[4] = {depth_m(x, y), depth_m(right, y), depth_m(x, below), depth_m(right, below)};
  for (float depth : z) {
    if (!IsMeasured(depth)) return {};
  }
  const auto [nearest, farthest] = std::minmax_element(std::begin(z), std::end(z));
  if (double(*farthest) > double(*nearest) * (1 + same_surface)) return {};
  const double fx = pixel.x - x0, fy = pixel.y - y0;
  const double inverse = (1 - fy) * ((1 - fx) / double(z[0]) + fx / double(z[1])) +
                         fy * ((1 - fx) / double(z[2]) + fx / double(z[3]));
  return camera.Unproject(pixel.x, pixel.y, 1 / inverse);
}

}  // namespace silt::tracker
