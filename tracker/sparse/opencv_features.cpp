// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/opencv_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <tuple>
#include <utility>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

cv::Mat Bytes(const Image<float>& intensity) {
  cv::Mat bytes(intensity.height(), intensity.width(), CV_8U);
  for (int y = 0; y < intensity.height(); ++y) {
    const float* in = intensity.row(y);
    for (int x = 0; x < intensity.width(); ++x) {
      const float level = std::clamp(in[x], 0.0f, 1.0f) * 255.0f;
      bytes.at<std::uint8_t>(y, x) = std::uint8_t(std::isfinite(level) ? level + 0.5f : 0.0f);
    }
  }
  return bytes;
}

cv::Ptr<cv::Feature2D> MakeDetector(const FeatureOptions& options) {
  if (options.kind == FeatureKind::kSift) {
    return cv::SIFT::create(options.max_features, 3, options.sift_contrast);
  }
  if (options.kind == FeatureKind::kAkaze) {
    return cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, float(options.akaze_threshold));
  }
  SILT_CHECK(options.kind == FeatureKind::kOrb);
  return cv::ORB::create(options.max_features, 1.2f, 8, 31, 0, 2, cv::ORB::HARRIS_SCORE, 31,
                         options.orb_fast_threshold);
}

// Their order: strongest first; places break ties, so that it never rests on the detector's.
std::vector<int> StrongestFirst(const std::vector<cv::KeyPoint>& points, int max_features) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](int i) {
    const cv::KeyPoint& p = points[std::size_t(i)];
    return std::tuple(-p.response, p.pt.y, p.pt.x, p.size, p.angle, i);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
  order.resize(std::min(order.size(), std::size_t(max_features)));
  return order;
}

// A row of descriptors: bytes that hold bits, or numbers, which are given the norm 1.
void CopyDescriptor(const cv::Mat& descriptors, int row, Feature* feature) {
  if (descriptors.type() == CV_8U) {
    const std::uint8_t* bits = descriptors.ptr<std::uint8_t>(row);
    feature->bits.assign(bits, bits + descriptors.cols);
    return;
  }
  const float* numbers = descriptors.ptr<float>(row);
  feature->descriptor.assign(numbers, numbers + descriptors.cols);
  double squares = 0;
  for (const float value : feature->descriptor) squares += double(value) * double(value);
  const float factor = squares > 0 ? float(1 / std::sqrt(squares)) : 0;
  for (float& value : feature->descriptor) value *= factor;
}

}  // namespace

std::vector<Feature> DetectOpencvFeatures(const Image<float>& intensity,
                                          const FeatureOptions& options) {
  options.Validate();
  constexpr int kSmallest = 64;  // the detectors' patches and octaves need as much
  if (intensity.width() < kSmallest || intensity.height() < kSmallest) return {};
  std::vector<cv::KeyPoint> points;
  cv::Mat descriptors;
  MakeDetector(options)->detectAndCompute(Bytes(intensity), cv::noArray(), points, descriptors);
  std::vector<Feature> features;
  for (const int i : StrongestFirst(points, options.max_features)) {
    const cv::KeyPoint& point = points[std::size_t(i)];
    Feature feature{{double(point.pt.x), double(point.pt.y)},
                    double(point.size),
                    double(point.angle) * std::numbers::pi / 180,
                    {},
                    {}};
    CopyDescriptor(descriptors, i, &feature);
    features.push_back(std::move(feature));
  }
  return features;
}

}  // namespace silt::tracker
