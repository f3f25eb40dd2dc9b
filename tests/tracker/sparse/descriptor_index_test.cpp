// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/descriptor_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>
#include <thread>

#include "silt/core/random.h"

namespace silt::tracker {
namespace {

std::vector<Feature> RandomFeatures(int count, std::uint64_t seed, double noise = 0,
                                    std::uint64_t noise_seed = 0) {
  const CounterRandom random(seed), jitter(noise_seed, 1);
  std::vector<Feature> features(static_cast<std::size_t>(count));
  std::uint64_t draw = 0;
  for (Feature& feature : features) {
    double squared = 0;
    feature.descriptor.resize(64);
    for (float& value : feature.descriptor) {
      value = float(random.Normal(draw) / 8 + noise * jitter.Normal(draw));
      squared += double(value) * double(value);
      ++draw;
    }
    for (float& value : feature.descriptor) value = float(value / std::sqrt(squared));
  }
  return features;
}

// A descriptor and its slightly disturbed twin are far closer than two random ones (√2).
TEST(DescriptorIndex, FindsTheTwins) {
  const auto keyframe = RandomFeatures(600, 1), current = RandomFeatures(600, 1, 0.02, 7);
  const auto matches = DescriptorIndex(keyframe, 3).Match(current);
  int right = 0;
  for (const FeatureMatch& match : matches) right += match.keyframe == match.current;
  EXPECT_GT(right, 570);  // k-d trees are approximate
  for (const FeatureMatch& match : matches) {
    if (match.keyframe == match.current) {
      EXPECT_LT(match.distance, 0.5f);
    }
  }
}

TEST(DescriptorIndex, KeepsTheNearestOfSeveralClaims) {
  const auto keyframe = RandomFeatures(40, 1);
  std::vector<Feature> current = {keyframe[5], keyframe[5], keyframe[9], keyframe[5]};
  current[0].descriptor[0] += 0.05f;
  const auto matches = DescriptorIndex(keyframe, 3).Match(current);
  EXPECT_EQ(matches, (std::vector<FeatureMatch>{{5, 1, 0}, {9, 2, 0}}));
}

TEST(DescriptorIndex, DependsOnItsInputAlone) {
  const auto keyframe = RandomFeatures(800, 1), current = RandomFeatures(800, 2);
  cv::theRNG() = cv::RNG(1234);
  const auto first = DescriptorIndex(keyframe, 3).Match(current);
  for (int i = 0; i < 17; ++i) cv::theRNG().next();
  EXPECT_EQ(DescriptorIndex(keyframe, 3).Match(current), first);
  std::vector<FeatureMatch> elsewhere;
  std::thread([&] { elsewhere = DescriptorIndex(keyframe, 3).Match(current); }).join();
  EXPECT_EQ(elsewhere, first);
  // Random descriptors have no clear nearest neighbour: other trees find others, so the equalities
  // above mean something.
  EXPECT_NE(DescriptorIndex(keyframe, 4).Match(current), first);
}

TEST(DescriptorIndex, LeavesTheGeneratorAsItWas) {
  cv::theRNG() = cv::RNG(99);
  const auto before = cv::theRNG().state;
  const DescriptorIndex index(RandomFeatures(100, 1), 5);
  index.Match(RandomFeatures(10, 2));
  EXPECT_EQ(cv::theRNG().state, before);
}

// 256 bits each, drawn at random, of which the current ones have one or two flipped.
TEST(DescriptorIndex, FindsBinaryTwinsAndTheirDistances) {
  std::vector<Feature> keyframe(100);
  const CounterRandom random(5);
  for (std::size_t i = 0; i < keyframe.size(); ++i) {
    for (int byte = 0; byte < 32; ++byte) {
      keyframe[i].bits.push_back(std::uint8_t(random.Bits(32 * i + std::size_t(byte))));
    }
  }
  std::vector<Feature> current = keyframe;
  for (std::size_t i = 0; i < current.size(); ++i) current[i].bits[3] ^= i % 2 == 0 ? 1 : 9;
  const auto matches = DescriptorIndex(keyframe, 3).Match(current);
  ASSERT_EQ(matches.size(), 100u);
  for (const FeatureMatch& match : matches) {
    EXPECT_EQ(match.keyframe, match.current);
    EXPECT_FLOAT_EQ(match.distance, 2 * std::sqrt(match.current % 2 == 0 ? 1 / 256.f : 2 / 256.f));
  }
}

TEST(DescriptorIndex, MatchesNothingWithNothing) {
  EXPECT_TRUE(DescriptorIndex({}, 1).Match(RandomFeatures(5, 1)).empty());
  EXPECT_TRUE(DescriptorIndex(RandomFeatures(5, 1), 1).Match({}).empty());
  EXPECT_EQ(DescriptorIndex(RandomFeatures(1, 1), 1).Match(RandomFeatures(1, 1)).size(), 1u);
}

}  // namespace
}  // namespace silt::tracker
