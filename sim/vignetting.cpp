// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/vignetting.h"

#include <cstdio>

#include "silt/core/error.h"

namespace silt::sim {

namespace {

// cos²θ = 1 / (1 + tan²θ) of the ray that the pixel sees.
double CosFourth(const PinholeCamera& camera, const Vec2d& pinhole_pixel) {
  const Vec3d ray = camera.Unproject(pinhole_pixel.x, pinhole_pixel.y, 1.0);
  const double cos2 = 1 / Dot(ray, ray);
  return cos2 * cos2;
}

double Polynomial(const Vignetting& v, double r2) {
  return 1 + r2 * (v.a1 + r2 * (v.a2 + r2 * v.a3));
}

[[noreturn]] void FailAt(int x, int y, double share) {
  char text[160];
  std::snprintf(
      text, sizeof text,
      "vignetting: the share of light at pixel (%d, %d) is %g; choose a1, a2, a3 that keep "
      "it above 0 and at most 1",
      x, y, share);
  throw Error(text);
}

}  // namespace

Image<float> VignettingShares(const Vignetting& vignetting, const PinholeCamera& camera,
                              const LensMap* lens) {
  const double width = camera.width, height = camera.height;
  const double half_diagonal2 = (width * width + height * height) / 4;
  Image<float> shares(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double dx = x - camera.cx, dy = y - camera.cy;
      const double polynomial = Polynomial(vignetting, (dx * dx + dy * dy) / half_diagonal2);
      if (!(polynomial > 0 && polynomial <= 1.0001)) FailAt(x, y, polynomial);
      const Vec2d pinhole =
          lens == nullptr ? Vec2d{double(x), double(y)} : lens->PinholePixel(x, y);
      const double natural = vignetting.cos4 ? CosFourth(camera, pinhole) : 1;
      shares(x, y) = float(natural * polynomial);
    }
  }
  return shares;
}

}  // namespace silt::sim
