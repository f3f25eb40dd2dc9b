// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

// Noise laws are tested on 256 × 256 independent values. Mean and variance are compared at 5
// standard deviations of their own, the variance at 5 % where that is less: with another seed than
// the fixed one, a comparison fails by chance once in 1.7 million.
namespace silt::sim {

inline constexpr int kWidth = 256, kHeight = 256, kCount = kWidth * kHeight;
inline constexpr double kSigmas = 5;

inline Image<Vec3f> UniformSignal(double level) {
  return {kWidth, kHeight, {float(level), float(level), float(level)}};
}

inline std::vector<double> ChannelValues(const Image<Vec3f>& image, int channel) {
  std::vector<double> values;
  for (const Vec3f& v : image) {
    values.push_back(double(channel == 0 ? v.x : channel == 1 ? v.y : v.z));
  }
  return values;
}

// The variance of a sample variance is (μ4 − σ⁴)/n, with the sample's own fourth moment.
inline void ExpectMeanAndVariance(const std::vector<double>& values, double mean, double variance) {
  const auto n = double(values.size());
  double sum = 0, squares = 0, fourths = 0;
  for (const double value : values) {
    const double d = value - mean;
    sum += d;
    squares += d * d;
    fourths += d * d * d * d;
  }
  EXPECT_NEAR(sum / n, 0, kSigmas * std::sqrt(variance / n)) << "mean " << mean;
  const double error = std::sqrt((fourths / n - squares / n * squares / n) / n);
  EXPECT_NEAR(squares / n / variance, 1, std::min(kSigmas * error / variance, 0.05))
      << "mean " << mean << ", variance " << variance;
}

}  // namespace silt::sim
