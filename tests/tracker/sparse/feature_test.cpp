// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/feature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/tracker/sparse/sparse_initializer.h"
#include "textured_planes.h"

namespace silt::tracker {
namespace {

bool Same(const std::vector<Feature>& a, const std::vector<Feature>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.pixel.x == q.pixel.x && p.pixel.y == q.pixel.y && p.scale == q.scale &&
           p.angle_rad == q.angle_rad && p.descriptor == q.descriptor && p.bits == q.bits;
  });
}

struct Kind {
  FeatureKind kind;
  std::size_t numbers, bytes;  // of a descriptor
};
void PrintTo(const Kind& kind, std::ostream* out) {
  *out << std::array{"surf", "sift", "orb", "akaze"}[std::size_t(kind.kind)];
}

class EveryFeature : public testing::TestWithParam<Kind> {
 protected:
  static FeatureOptions Options() { return {GetParam().kind}; }
};

TEST_P(EveryFeature, HasItsDescriptor) {
  const auto features = DetectFeatures(ViewOfPlanes(kIclNuimCamera, {}).intensity, Options());
  ASSERT_GT(features.size(), 200u);
  EXPECT_LE(features.size(), 700u);
  for (const Feature& feature : features) {
    ASSERT_EQ(feature.descriptor.size(), GetParam().numbers);
    ASSERT_EQ(feature.bits.size(), GetParam().bytes);
    EXPECT_GT(feature.scale, 0);
    double squared = 0;
    for (const float value : feature.descriptor) squared += double(value) * double(value);
    EXPECT_NEAR(squared, GetParam().numbers > 0 ? 1 : 0, 1e-5);
  }
}

TEST_P(EveryFeature, KeepsTheStrongestWhateverTheNumberOfThreads) {
  const Image<float> image = ViewOfPlanes(kIclNuimCamera, {}).intensity;
  SetThreadCount(1);
  const auto one = DetectFeatures(image, Options());
  SetThreadCount(4);
  EXPECT_TRUE(Same(one, DetectFeatures(image, Options())));
  SetThreadCount(0);
  FeatureOptions few = Options();
  few.max_features = 50;
  EXPECT_LE(DetectFeatures(image, few).size(), 50u);
}

// Large turns too: the angle of a feature has the same sense whoever finds it.
TEST_P(EveryFeature, FindsTheCamera) {
  const Keyframe keyframe = KeyframeOf(ViewOfPlanes(kIclNuimCamera, {}));
  for (const SE3d& truth : {SE3d::Exp({{0.03, -0.05, 0.02}, {0.05, -0.03, 0.04}}),
                            SE3d::Exp({{0.02, 0.03, 0.5}, {0.03, 0.05, -0.04}})}) {
    const View current = ViewOfPlanes(kIclNuimCamera, truth.Inverse());
    SparseInitializer initializer(OptionsFor(GetParam().kind));
    const Frame frame;
    const InitialEstimate found =
        initializer.Estimate({keyframe, frame, current.intensity, kIclNuimCamera, 7, 1});
    ASSERT_TRUE(found.current_from_keyframe);
    const SE3d error = *found.current_from_keyframe * truth.Inverse();
    EXPECT_LT(Norm(error.translation), 0.015);
    EXPECT_LT(RotationAngle(error.rotation), 0.008);
    EXPECT_GT(found.inliers, 40);
  }
}

TEST_P(EveryFeature, FindsNothingInBlankTinyOrMissingImagesAndSurvivesValuesOutOfRange) {
  EXPECT_TRUE(DetectFeatures(Image<float>(640, 480, 0.5f), Options()).empty());
  EXPECT_TRUE(DetectFeatures(Image<float>(), Options()).empty());
  for (int size = 1; size <= 80; size += 13) {
    EXPECT_TRUE(DetectFeatures(Image<float>(size, 2 * size, 0.5f), Options()).empty());
  }
  Image<float> image = ViewOfPlanes(kIclNuimCamera, {}).intensity;
  image(20, 20) = std::numeric_limits<float>::quiet_NaN();
  image(90, 80) = std::numeric_limits<float>::infinity();
  for (const Feature& feature : DetectFeatures(image, Options())) {
    EXPECT_TRUE(std::isfinite(feature.pixel.x + feature.pixel.y + feature.scale));
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryFeature,
                         testing::Values(Kind{FeatureKind::kSurf, 64, 0},
                                         Kind{FeatureKind::kSift, 128, 0},
                                         Kind{FeatureKind::kOrb, 0, 32},
                                         Kind{FeatureKind::kAkaze, 0, 61}));

TEST(FeatureOptions, RejectsValuesOutOfRange) {
  const auto refuses = [](auto member, auto value) {
    FeatureOptions options;
    options.*member = value;
    EXPECT_THROW(options.Validate(), Error);
  };
  refuses(&FeatureOptions::max_features, 0);
  refuses(&FeatureOptions::surf_threshold, std::nan(""));
  refuses(&FeatureOptions::sift_contrast, 0.0);
  refuses(&FeatureOptions::orb_fast_threshold, 0);
  refuses(&FeatureOptions::akaze_threshold, -1.0);
}

}  // namespace
}  // namespace silt::tracker
