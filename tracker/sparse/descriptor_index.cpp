// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/descriptor_index.h"

#include <algorithm>
#include <limits>
#include <opencv2/features2d.hpp>

namespace silt::tracker {
namespace {

constexpr int kTrees = 4;
constexpr int kChecks = 32;  // leaves visited per query

cv::Mat Stacked(const std::vector<SurfFeature>& features) {
  cv::Mat rows(int(features.size()), int(SurfDescriptor{}.size()), CV_32F);
  for (int i = 0; i < rows.rows; ++i) {
    const SurfDescriptor& descriptor = features[std::size_t(i)].descriptor;
    std::copy(descriptor.begin(), descriptor.end(), rows.ptr<float>(i));
  }
  return rows;
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

struct DescriptorIndex::Trees {
  int size = 0;
  mutable cv::FlannBasedMatcher matcher{cv::makePtr<cv::flann::KDTreeIndexParams>(kTrees),
                                        cv::makePtr<cv::flann::SearchParams>(kChecks)};
};

DescriptorIndex::DescriptorIndex(const std::vector<SurfFeature>& keyframe, std::uint64_t seed)
    : trees_(std::make_unique<Trees>()) {
  trees_->size = int(keyframe.size());
  if (keyframe.empty()) return;
  const SeededGenerator seeded(seed);
  trees_->matcher.add(std::vector<cv::Mat>{Stacked(keyframe)});
  trees_->matcher.train();
}

DescriptorIndex::~DescriptorIndex() = default;
DescriptorIndex::DescriptorIndex(DescriptorIndex&&) noexcept = default;
DescriptorIndex& DescriptorIndex::operator=(DescriptorIndex&&) noexcept = default;

std::vector<FeatureMatch> DescriptorIndex::Match(const std::vector<SurfFeature>& current) const {
  if (trees_->size == 0 || current.empty()) return {};
  std::vector<std::vector<cv::DMatch>> nearest;
  trees_->matcher.knnMatch(Stacked(current), nearest, 1);
  std::vector<FeatureMatch> matches;
  for (const std::vector<cv::DMatch>& found : nearest) {
    if (found.empty() || found.front().trainIdx < 0) continue;
    matches.push_back({found.front().trainIdx, found.front().queryIdx, found.front().distance});
  }
  return OneToOne(matches, trees_->size);
}

}  // namespace silt::tracker
