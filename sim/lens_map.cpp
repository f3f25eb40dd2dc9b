// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lens_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

// A pixel shows at most so much more than it would at the centre, in area; beyond lies a fold.
constexpr double kLargestStretch = 100;
constexpr int kChecksBetween = 8;
constexpr Vec2d kFolded{std::numeric_limits<double>::quiet_NaN(), 0};

[[noreturn]] void FailAt(const LensDistortion& lens, int x, int y) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "lens: k1 %g k2 %g p1 %g p2 %g k3 %g fold the picture at pixel (%d, %d); use weaker "
      "coefficients or a narrower camera",
      lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, x, y);
  throw Error(text);
}

// The derivative is symmetric: positive definite where the picture is neither folded nor turned.
bool Unfolded(const LensDistortion& lens, const Vec2d& p) {
  const auto derivative = lens.DistortDerivative(p);
  return derivative.xx > 0 && derivative.Determinant() > 1 / kLargestStretch;
}

// Whether `next` is the inverse of `distorted` on the same sheet as its neighbour `p`: no fold lies
// between them.
bool Continues(const LensDistortion& lens, const Vec2d& p, const Vec2d& next,
               const Vec2d& distorted) {
  const Vec2d error = lens.Distort(next) - distorted;
  const double scale = 1 + std::hypot(distorted.x, distorted.y);
  if (!(std::hypot(error.x, error.y) < 1e-12 * scale)) return false;
  for (int i = 0; i <= kChecksBetween; ++i) {
    if (!Unfolded(lens, p + (double(i) / kChecksBetween) * (next - p))) return false;
  }
  return true;
}

}  // namespace

LensMap::LensMap(const PinholeCamera& camera, const LensDistortion& lens)
    : camera_(camera), lens_(lens), centers_(camera.width + 2, camera.height + 2) {
  const int middle_x = int(std::clamp(std::round(camera.cx), 0.0, camera.width - 1.0));
  const int middle_y = int(std::clamp(std::round(camera.cy), 0.0, camera.height - 1.0));
  At(middle_x, middle_y) = Reach(middle_x, middle_y);
  for (int y = middle_y; y > -1; --y) {
    At(middle_x, y - 1) = Continue(middle_x, y - 1, At(middle_x, y));
  }
  for (int y = middle_y; y < camera.height; ++y) {
    At(middle_x, y + 1) = Continue(middle_x, y + 1, At(middle_x, y));
  }
  ParallelFor(camera.height + 2, [&](int row) {
    const int y = row - 1;
    for (int x = middle_x; x > -1; --x) At(x - 1, y) = Continue(x - 1, y, At(x, y));
    for (int x = middle_x; x < camera_.width; ++x) At(x + 1, y) = Continue(x + 1, y, At(x, y));
  });
  RequireUnfolded();
}

Vec2d LensMap::Continue(int x, int y, const Vec2d& neighbour) const {
  const Vec2d distorted = Distorted(x, y);
  const Vec2d p = lens_.Undistort(distorted, neighbour);
  return Continues(lens_, neighbour, p, distorted) ? p : kFolded;
}

// Tells of the pixel nearest the centre, the same whichever thread found its row folded first.
void LensMap::RequireUnfolded() const {
  double nearest = std::numeric_limits<double>::infinity();
  int folded_x = 0, folded_y = 0;
  for (int y = -1; y <= camera_.height; ++y) {
    for (int x = -1; x <= camera_.width; ++x) {
      const double distance = std::hypot(x - camera_.cx, y - camera_.cy);
      if (!std::isnan(centers_(x + 1, y + 1).x) || distance >= nearest) continue;
      nearest = distance;
      folded_x = x;
      folded_y = y;
    }
  }
  if (std::isfinite(nearest)) FailAt(lens_, folded_x, folded_y);
}

Vec2d LensMap::Reach(int x, int y) const {
  const Vec2d distorted = Distorted(x, y);
  const double pixels = std::hypot(x - camera_.cx, y - camera_.cy);
  const int steps = 1 + int(std::min(pixels, 1e5));
  Vec2d p;
  for (int i = 1; i <= steps; ++i) {
    const Vec2d target = (double(i) / steps) * distorted;
    const Vec2d next = lens_.Undistort(target, p);
    if (!Continues(lens_, p, next, target)) return kFolded;
    p = next;
  }
  return p;
}

Vec2d LensMap::PinholePixel(double u, double v) const {
  const int x = std::clamp(int(std::lround(u)), -1, camera_.width);
  const int y = std::clamp(int(std::lround(v)), -1, camera_.height);
  const Vec2d p = lens_.Undistort(Distorted(u, v), centers_(x + 1, y + 1));
  return {camera_.fx * p.x + camera_.cx, camera_.fy * p.y + camera_.cy};
}

}  // namespace silt::sim
