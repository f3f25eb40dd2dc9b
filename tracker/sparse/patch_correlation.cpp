// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/patch_correlation.h"

#include <cmath>
#include <optional>
#include <vector>

namespace silt::tracker {
namespace {

double Bilinear(const Image<float>& image, int x, int y, double fx, double fy) {
  const float* upper = image.row(y) + x;
  const float* lower = image.row(y + 1) + x;
  return (1 - fy) * ((1 - fx) * double(upper[0]) + fx * double(upper[1])) +
         fy * ((1 - fx) * double(lower[0]) + fx * double(lower[1]));
}

// The samples less their mean; nothing where one lies outside the image.
std::optional<std::vector<double>> CentredSamples(const Image<float>& image, const Patch& patch,
                                                  int radius) {
  const double c = std::cos(patch.angle_rad) * patch.spacing_px;
  const double s = std::sin(patch.angle_rad) * patch.spacing_px;
  std::vector<double> samples;
  samples.reserve(std::size_t(2 * radius + 1) * std::size_t(2 * radius + 1));
  double sum = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      const double u = patch.pixel.x + c * i - s * j, v = patch.pixel.y + s * i + c * j;
      const double x = std::floor(u), y = std::floor(v);
      if (!(x >= 0 && y >= 0 && x < image.width() - 1 && y < image.height() - 1)) return {};
      samples.push_back(Bilinear(image, int(x), int(y), u - x, v - y));
      sum += samples.back();
    }
  }
  for (double& sample : samples) sample -= sum / double(samples.size());
  return samples;
}

}  // namespace

double PatchCorrelation(const Image<float>& a, const Patch& in_a, const Image<float>& b,
                        const Patch& in_b, int radius) {
  const auto samples_a = CentredSamples(a, in_a, radius);
  const auto samples_b = CentredSamples(b, in_b, radius);
  if (!samples_a || !samples_b) return -1;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < samples_a->size(); ++i) {
    const double p = (*samples_a)[i], q = (*samples_b)[i];
    ab += p * q;
    aa += p * p;
    bb += q * q;
  }
  // A patch whose contrast is far below an 8-bit step (σ < 4e-5) holds rounding, not texture.
  const double least = 1.6e-9 * double(samples_a->size());
  return aa > least && bb > least ? ab / std::sqrt(aa * bb) : -1;
}

}  // namespace silt::tracker
