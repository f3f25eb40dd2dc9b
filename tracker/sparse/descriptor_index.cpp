// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/descriptor_index.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <type_traits>

#include "silt/core/error.h"

namespace silt::tracker {
namespace {

constexpr int kTrees = 4;
constexpr int kChecks = 32;  // leaves visited per query

// One row each: numbers or, of binary descriptors, bytes.
cv::Mat Stacked(const std::vector<Feature>& features) {
  const auto fill = [&](auto member, int type) {
    cv::Mat rows(int(features.size()), int((features.front().*member).size()), type);
    for (int i = 0; i < rows.rows; ++i) {
      const auto& descriptor = features[std::size_t(i)].*member;
      SILT_CHECK(int(descriptor.size()) == rows.cols);
      std::copy(descriptor.begin(), descriptor.end(),
                rows.ptr<typename std::decay_t<decltype(descriptor)>::value_type>(i));
    }
    return rows;
  };
  return features.front().bits.empty() ? fill(&Feature::descriptor, CV_32F)
                                       : fill(&Feature::bits, CV_8U);
}

// The Euclidean distance of two binary descriptors, taken for vectors of ±1/√n: two of their n bits
// in a half differ by √2, as vectors of numbers do that have nothing in common.
float BinaryDistance(float differing_bits, int n) {
  return 2 * std::sqrt(differing_bits / float(n));
}

// Seeds the thread's OpenCV generator, from which FLANN draws its trees, and puts it back.
class SeededGenerator {
 public:
  explicit SeededGenerator(std::uint64_t seed) : before_(cv::theRNG()) {
    cv::theRNG() = cv::RNG(seed);
  }
  ~SeededGenerator() { cv::theRNG() = before_; }
  SeededGenerator(const SeededGenerator&) = delete;
  SeededGenerator& operator=(const SeededGenerator&) = delete;

 private:
  cv::RNG before_;
};

// Of the matches to one keyframe feature only the nearest stays, the first of equals.
std::vector<FeatureMatch> OneToOne(const std::vector<FeatureMatch>& matches, int keyframe_size) {
  std::vector<int> best(std::size_t(keyframe_size), -1);
  for (int i = 0; i < int(matches.size()); ++i) {
    const FeatureMatch& match = matches[std::size_t(i)];
    int& holder = best[std::size_t(match.keyframe)];
    if (holder < 0 || match.distance < matches[std::size_t(holder)].distance) holder = i;
  }
  std::vector<FeatureMatch> kept;
  for (int i = 0; i < int(matches.size()); ++i) {
    const FeatureMatch& match = matches[std::size_t(i)];
    if (best[std::size_t(match.keyframe)] == i) kept.push_back(match);
  }
  return kept;
}

}  // namespace

struct DescriptorIndex::Descriptors {
  int size = 0;
  int bits = 0;  // of a binary descriptor, else 0
  cv::Ptr<cv::DescriptorMatcher> matcher;

  float Distance(const cv::DMatch& match) const {
    return bits > 0 ? BinaryDistance(match.distance, bits) : match.distance;
  }
};

DescriptorIndex::DescriptorIndex(const std::vector<Feature>& keyframe, std::uint64_t seed)
    : descriptors_(std::make_unique<Descriptors>()) {
  descriptors_->size = int(keyframe.size());
  if (keyframe.empty()) return;
  const SeededGenerator seeded(seed);
  descriptors_->bits = 8 * int(keyframe.front().bits.size());
  if (descriptors_->bits > 0) {
    descriptors_->matcher = cv::makePtr<cv::BFMatcher>(cv::NORM_HAMMING);
  } else {
    descriptors_->matcher =
        cv::makePtr<cv::FlannBasedMatcher>(cv::makePtr<cv::flann::KDTreeIndexParams>(kTrees),
                                           cv::makePtr<cv::flann::SearchParams>(kChecks));
  }
  descriptors_->matcher->add(std::vector<cv::Mat>{Stacked(keyframe)});
  descriptors_->matcher->train();
}

DescriptorIndex::~DescriptorIndex() = default;
DescriptorIndex::DescriptorIndex(DescriptorIndex&&) noexcept = default;
DescriptorIndex& DescriptorIndex::operator=(DescriptorIndex&&) noexcept = default;

std::vector<FeatureMatch> DescriptorIndex::Match(const std::vector<Feature>& current) const {
  if (descriptors_->size == 0 || current.empty()) return {};
  std::vector<std::vector<cv::DMatch>> nearest;
  descriptors_->matcher->knnMatch(Stacked(current), nearest, 1);
  std::vector<FeatureMatch> matches;
  for (const std::vector<cv::DMatch>& found : nearest) {
    if (found.empty() || found.front().trainIdx < 0) continue;
    matches.push_back(
        {found.front().trainIdx, found.front().queryIdx, descriptors_->Distance(found.front())});
  }
  return OneToOne(matches, descriptors_->size);
}

}  // namespace silt::tracker
