// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/sparse/sparse_initializer.h"

#include <gtest/gtest.h>

#include <thread>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "textured_planes.h"

namespace silt::tracker {
namespace {

SE3d CurrentFromKeyframe(double degrees, double metres) {
  const double angle = degrees * 3.14159265358979 / 180;
  return SE3d::Exp(
      {{0.3 * angle, -0.5 * angle, 0.81 * angle}, {0.7 * metres, -0.4 * metres, 0.59 * metres}});
}

View Moved(const SE3d& current_from_keyframe) {
  return ViewOfPlanes(kIclNuimCamera, current_from_keyframe.Inverse());
}

SparseEstimate Estimate(SparseInitializer& initializer, const Keyframe& keyframe,
                        const View& current, int frame_index = 1) {
  const Frame frame;
  return initializer.EstimateInSteps(
      {keyframe, frame, current.intensity, kIclNuimCamera, 7, frame_index});
}

struct Motion {
  double degrees, metres;
};
void PrintTo(const Motion& motion, std::ostream* out) {
  *out << motion.degrees << "_deg_" << motion.metres << "_m";
}

class SparseInitializerMotion : public testing::TestWithParam<Motion> {};

// Features are good for about 0.5 px; 1 px is 4 mm on the wall and 2 mrad.
TEST_P(SparseInitializerMotion, IsRecovered) {
  const SE3d truth = CurrentFromKeyframe(GetParam().degrees, GetParam().metres);
  SparseInitializer initializer;
  const SparseEstimate found =
      Estimate(initializer, KeyframeOf(ViewOfPlanes(kIclNuimCamera, {})), Moved(truth));
  ASSERT_TRUE(found.estimate.current_from_keyframe);
  const SE3d error = *found.estimate.current_from_keyframe * truth.Inverse();
  EXPECT_LT(Norm(error.translation), 0.01);
  EXPECT_LT(RotationAngle(error.rotation), 0.006);
  EXPECT_GT(found.estimate.inliers, 40);
  EXPECT_LT(found.rmse_px, 1.2);
}

INSTANTIATE_TEST_SUITE_P(PlanesSeenAnew, SparseInitializerMotion,
                         testing::Values(Motion{0, 0}, Motion{1, 0.01}, Motion{8, 0.08},
                                         Motion{15, 0.13}, Motion{30, 0.1}));

TEST(SparseInitializer, EachCheckThinsTheMatches) {
  SparseInitializer initializer;
  const SparseEstimate found = Estimate(initializer, KeyframeOf(ViewOfPlanes(kIclNuimCamera, {})),
                                        Moved(CurrentFromKeyframe(15, 0.13)));
  EXPECT_LE(found.matched, std::min(found.keyframe_features, found.current_features));
  EXPECT_LT(found.near, found.matched);
  EXPECT_LT(found.correlated, found.near);
  EXPECT_LT(found.epipolar, found.correlated);
  EXPECT_LE(found.with_depth, found.epipolar);
  EXPECT_LE(found.estimate.inliers, found.with_depth);
  EXPECT_EQ(found.estimate.matches, found.epipolar);
  EXPECT_GT(found.estimate.milliseconds, 0);
}

// Bit for bit, whatever was asked before, on whichever thread, on however many.
TEST(SparseInitializer, IsAPureFunctionOfItsInput) {
  const Keyframe first = KeyframeOf(ViewOfPlanes(kIclNuimCamera, {}), 0);
  const Keyframe second = KeyframeOf(Moved(CurrentFromKeyframe(5, 0.05)), 1);
  const View near = Moved(CurrentFromKeyframe(8, 0.06)), far = Moved(CurrentFromKeyframe(12, 0.1));
  const auto bits = [](const SparseEstimate& found) {
    const SE3d& pose = found.estimate.current_from_keyframe.value();
    return std::vector<double>{
        pose.rotation.w,    pose.rotation.x,    pose.rotation.y,    pose.rotation.z,
        pose.translation.x, pose.translation.y, pose.translation.z, double(found.estimate.inliers)};
  };
  SparseInitializer forwards;
  std::vector<std::vector<double>> expected;
  for (const Keyframe* keyframe : {&first, &second}) {
    for (const View* view : {&near, &far}) {
      expected.push_back(bits(Estimate(forwards, *keyframe, *view)));
    }
  }
  SparseOptions forgetful;
  forgetful.max_cached_keyframes = 1;
  SparseInitializer backwards(forgetful);
  std::vector<std::vector<double>> found(4);
  SetThreadCount(1);
  std::thread([&] {
    found[3] = bits(Estimate(backwards, second, far));
    found[1] = bits(Estimate(backwards, first, far));
    found[2] = bits(Estimate(backwards, second, near));
    found[0] = bits(Estimate(backwards, first, near));
  }).join();
  SetThreadCount(0);
  EXPECT_EQ(found, expected);
}

TEST(SparseInitializer, FindsNothingInBlankImages) {
  const View view = ViewOfPlanes(kIclNuimCamera, {});
  const View blank{Image<float>(640, 480, 0.5f), view.depth_m};
  SparseInitializer initializer;
  EXPECT_FALSE(Estimate(initializer, KeyframeOf(view, 0), blank).estimate.current_from_keyframe);
  EXPECT_FALSE(Estimate(initializer, KeyframeOf(blank, 1), view).estimate.current_from_keyframe);
  EXPECT_FALSE(Estimate(initializer, KeyframeOf(blank, 2), blank).estimate.current_from_keyframe);
}

TEST(SparseInitializer, FindsNothingWithoutDepth) {
  View view = ViewOfPlanes(kIclNuimCamera, {});
  const View current = view;
  view.depth_m = Image<float>(640, 480);
  SparseInitializer initializer;
  SparseEstimate found = Estimate(initializer, KeyframeOf(view, 0), current);
  EXPECT_FALSE(found.estimate.current_from_keyframe);
  EXPECT_GT(found.epipolar, 100);
  EXPECT_EQ(found.with_depth, 0);
  view.depth_m = {};
  found = Estimate(initializer, KeyframeOf(view, 1), current);
  EXPECT_FALSE(found.estimate.current_from_keyframe);
}

// The other end of the wall shows nothing that the keyframe shows.
TEST(SparseInitializer, FindsNothingBetweenUnrelatedImages) {
  SparseInitializer initializer;
  const View elsewhere = ViewOfPlanes(kIclNuimCamera, {{}, {20, 10, 0}});
  const SparseEstimate found =
      Estimate(initializer, KeyframeOf(ViewOfPlanes(kIclNuimCamera, {})), elsewhere);
  EXPECT_FALSE(found.estimate.current_from_keyframe);
  EXPECT_GT(found.matched, 100);
}

TEST(SparseInitializer, RejectsOptionsOutOfRange) {
  SparseOptions options;
  options.max_cached_keyframes = 0;
  EXPECT_THROW(SparseInitializer{options}, Error);
  options = {};
  options.features.max_features = 0;
  EXPECT_THROW(SparseInitializer{options}, Error);
}

}  // namespace
}  // namespace silt::tracker
