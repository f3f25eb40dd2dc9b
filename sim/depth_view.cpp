// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/depth_view.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

namespace {

constexpr float kOneSurface = 1.05f;

// Four pixels about a place and how far it lies between them.
struct Taps {
  float depth[4];  // row by row
  double fx, fy;

  Taps(const Image<float>& depth_m, double u, double v) {
    const double x = std::clamp(u, 0.0, depth_m.width() - 1.0);
    const double y = std::clamp(v, 0.0, depth_m.height() - 1.0);
    const int x0 = int(x), y0 = int(y);
    const int x1 = std::min(x0 + 1, depth_m.width() - 1),
              y1 = std::min(y0 + 1, depth_m.height() - 1);
    depth[0] = depth_m(x0, y0);
    depth[1] = depth_m(x1, y0);
    depth[2] = depth_m(x0, y1);
    depth[3] = depth_m(x1, y1);
    fx = x - x0;
    fy = y - y0;
  }

  float Bilinear() const {
    const double weight[] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      if (weight[i] > 0 && !(depth[i] > 0)) return 0;
      sum += weight[i] * double(depth[i]);
    }
    return float(sum);
  }
  float Nearest() const { return depth[(fx >= 0.5 ? 1 : 0) + (fy >= 0.5 ? 2 : 0)]; }
  bool OneSurface() const {
    const auto [low, high] = std::minmax_element(depth, depth + 4);
    return *low > 0 && *high <= kOneSurface * *low;
  }
};

}  // namespace

double DepthView::CosIncidence(int x, int y) const {
  const Vec2d pixel = lens == nullptr ? Vec2d{double(x), double(y)} : lens->PinholePixel(x, y);
  const Vec3d ray = Normalized(camera.Unproject(pixel.x, pixel.y, 1.0));
  return std::abs(Dot(ray, truth.normal_camera(x, y).Cast<double>()));
}

float DepthView::BilinearDepth(double u, double v) const {
  return Taps(truth.depth_m, u, v).Bilinear();
}

float DepthView::SurfaceDepth(double u, double v) const {
  const Taps taps(truth.depth_m, u, v);
  return taps.OneSurface() ? taps.Bilinear() : taps.Nearest();
}

}  // namespace silt::sim
