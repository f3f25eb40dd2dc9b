// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/exposure.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

namespace {

constexpr double kMiddleGray = 0.18, kWhitePixels = 0.02;

}  // namespace

double MeteredExposure(const std::vector<Image<Vec3f>>& radiance) {
  std::vector<double> luminances;
  double log_sum = 0;
  for (const Image<Vec3f>& image : radiance) {
    for (const Vec3f& c : image) {
      const double luminance = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
      if (!(luminance > 1e-6) || !std::isfinite(luminance)) continue;
      luminances.push_back(luminance);
      log_sum += std::log(luminance);
    }
  }
  if (luminances.empty()) return 1;
  const auto white = std::size_t(double(luminances.size() - 1) * (1 - kWhitePixels));
  std::nth_element(luminances.begin(), luminances.begin() + std::ptrdiff_t(white),
                   luminances.end());
  const double mean = std::exp(log_sum / double(luminances.size()));
  return std::min(kMiddleGray / mean, 1 / luminances[white]);
}

}  // namespace silt::sim
