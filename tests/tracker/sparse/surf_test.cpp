// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/surf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "textured_planes.h"

namespace silt::tracker {
namespace {

// A bright Gaussian spot on gray.
Image<float> Spot(double u, double v, double sigma) {
  Image<float> image(320, 240);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const double squared = (x - u) * (x - u) + (y - v) * (y - v);
      image(x, y) = float(0.3 + 0.6 * std::exp(-squared / (2 * sigma * sigma)));
    }
  }
  return image;
}

bool Same(const std::vector<Feature>& a, const std::vector<Feature>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.pixel.x == q.pixel.x && p.pixel.y == q.pixel.y && p.scale == q.scale &&
           p.angle_rad == q.angle_rad && p.descriptor == q.descriptor;
  });
}

// The detector samples every second pixel, or every fourth at larger scales, and interpolates.
TEST(Surf, FindsASpotAtItsPlaceAndScale) {
  for (const Vec2d place : {Vec2d{160, 120}, Vec2d{150.5, 118.25}, Vec2d{171.3, 127.7}}) {
    const auto features = DetectSurf(Spot(place.x, place.y, 4));
    ASSERT_FALSE(features.empty());
    EXPECT_NEAR(features[0].pixel.x, place.x, 0.35);
    EXPECT_NEAR(features[0].pixel.y, place.y, 0.35);
    EXPECT_NEAR(features[0].scale, 4, 1.5);
  }
}

TEST(Surf, PutsTheStrongestFirst) {
  Image<float> image = Spot(90, 120, 4);
  const Image<float> other = Spot(230, 120, 4);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] += 0.5f * (other.data()[i] - 0.3f);
  const auto features = DetectSurf(image);
  ASSERT_GT(features.size(), 1u);
  EXPECT_NEAR(features[0].pixel.x, 90, 0.5);
  EXPECT_NEAR(features[1].pixel.x, 230, 0.5);
}

TEST(Surf, GivesUnitDescriptorsAndKeepsTheStrongest) {
  const View view = ViewOfPlanes(kIclNuimCamera, {});
  const auto all = DetectSurf(view.intensity);
  ASSERT_GT(all.size(), 300u);
  for (const Feature& feature : all) {
    double squared = 0;
    for (float value : feature.descriptor) squared += double(value) * double(value);
    EXPECT_NEAR(squared, 1, 1e-5);
  }
  FeatureOptions few;
  few.max_features = 50;
  const auto strongest = DetectSurf(view.intensity, few);
  EXPECT_TRUE(Same(strongest, {all.begin(), all.begin() + 50}));
}

TEST(Surf, IsTheSameForAnyNumberOfThreads) {
  const View view = ViewOfPlanes(kIclNuimCamera, {});
  SetThreadCount(1);
  const auto one = DetectSurf(view.intensity);
  SetThreadCount(4);
  const auto four = DetectSurf(view.intensity);
  SetThreadCount(0);
  EXPECT_TRUE(Same(one, four));
}

TEST(Surf, FindsNothingInBlankTinyOrMissingImages) {
  EXPECT_TRUE(DetectSurf(Image<float>(640, 480, 0.5f)).empty());
  EXPECT_TRUE(DetectSurf(Image<float>()).empty());
  for (int size = 1; size <= 80; size += 13) {
    EXPECT_TRUE(DetectSurf(Image<float>(size, 2 * size, 0.5f)).empty());
  }
}

TEST(Surf, SurvivesValuesOutOfRange) {
  Image<float> image = Spot(160, 120, 4);
  image(20, 20) = std::numeric_limits<float>::quiet_NaN();
  image(25, 20) = std::numeric_limits<float>::infinity();
  image(30, 20) = -1e30f;
  for (const Feature& feature : DetectSurf(image)) {
    EXPECT_TRUE(std::isfinite(feature.pixel.x + feature.pixel.y + feature.scale));
    EXPECT_TRUE(std::isfinite(feature.descriptor[0]));
  }
}

TEST(Surf, RejectsOptionsOutOfRange) {
  const Image<float> image(100, 100);
  EXPECT_THROW(DetectSurf(image, {FeatureKind::kSurf, 0}), Error);
  EXPECT_THROW(DetectSurf(image, {FeatureKind::kSurf, 100, 0}), Error);
  EXPECT_THROW(DetectSurf(image, {FeatureKind::kSurf, 100, std::nan("")}), Error);
}

}  // namespace
}  // namespace silt::tracker
