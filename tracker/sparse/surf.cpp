// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/surf.h"

#include <dlib/image_keypoint.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::tracker {
namespace {

// 64 bits hold the sum of any image; 32 would overflow at 8 megapixels.
using IntegralImage = dlib::integral_image_generic<std::int64_t>;

// dlib sums integers: exact, and its thresholds are meant for 8 bits.
void Integrate(const Image<float>& intensity, IntegralImage* integral) {
  dlib::array2d<unsigned char> bytes(intensity.height(), intensity.width());
  for (int y = 0; y < intensity.height(); ++y) {
    const float* in = intensity.row(y);
    for (int x = 0; x < intensity.width(); ++x) {
      const float level = std::clamp(in[x], 0.0f, 1.0f) * 255.0f;
      bytes[y][x] = static_cast<unsigned char>(std::isfinite(level) ? level + 0.5f : 0.0f);
    }
  }
  integral->load(bytes);
}

// The window that the descriptor reads lies inside the image.
bool HasDescriptor(const IntegralImage& integral, const dlib::interest_point& point) {
  const auto window = static_cast<unsigned long>(32 * point.scale);
  return dlib::get_rect(integral).contains(dlib::centered_rect(point.center, window, window));
}

// Strongest first; places break ties, so that the order never rests on the sort.
std::vector<dlib::interest_point> Detect(const IntegralImage& integral,
                                         const FeatureOptions& options) {
  constexpr long kOctaves = 4, kIntervals = 6, kStep = 2;  // dlib's own choice
  dlib::hessian_pyramid pyramid;
  pyramid.build_pyramid(integral, kOctaves, kIntervals, kStep);
  std::vector<dlib::interest_point> points;
  dlib::get_interest_points(pyramid, options.surf_threshold, points);
  std::erase_if(points, [&](const auto& point) { return !HasDescriptor(integral, point); });
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::tuple(-a.score, a.center.y(), a.center.x(), a.scale) <
           std::tuple(-b.score, b.center.y(), b.center.x(), b.scale);
  });
  points.resize(std::min(points.size(), std::size_t(options.max_features)));
  return points;
}

Feature Describe(const IntegralImage& integral, const dlib::interest_point& point) {
  Feature feature;
  feature.pixel = {point.center.x(), point.center.y()};
  feature.scale = point.scale;
  feature.angle_rad = dlib::compute_dominant_angle(integral, point.center, point.scale);
  dlib::matrix<double, 64, 1> values;
  dlib::compute_surf_descriptor(integral, point.center, point.scale, feature.angle_rad, values);
  feature.descriptor.assign(values.begin(), values.end());
  return feature;
}

}  // namespace

std::vector<Feature> DetectSurf(const Image<float>& intensity, const FeatureOptions& options) {
  options.Validate();
  constexpr int kSmallest = 64;  // two windows of the smallest scale
  if (intensity.width() < kSmallest || intensity.height() < kSmallest) return {};
  IntegralImage integral;
  Integrate(intensity, &integral);
  const std::vector<dlib::interest_point> points = Detect(integral, options);
  std::vector<Feature> features(points.size());
  // Describing a feature takes 10–30 µs: batches of 32 keep the threads' overhead small.
  constexpr std::size_t kBatch = 32;
  ParallelFor(int((points.size() + kBatch - 1) / kBatch), [&](int batch) {
    const std::size_t end = std::min(points.size(), (std::size_t(batch) + 1) * kBatch);
    for (std::size_t i = std::size_t(batch) * kBatch; i < end; ++i) {
      features[i] = Describe(integral, points[i]);
    }
  });
  return features;
}

}  // namespace silt::tracker
