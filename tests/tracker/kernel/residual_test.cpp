// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/kernel/residual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/sums.h"

namespace silt::tracker::kernel {
namespace {

constexpr PinholeCamera kCamera{10, 10, 3.5, 2.5, 8, 6};

std::vector<float> Ramp() {
  std::vector<float> pixels;
  for (int i = 0; i < kCamera.width * kCamera.height; ++i) {
    pixels.push_back(0.1f * float(i % kCamera.width));
  }
  return pixels;
}

// I(u, v) = 0.1·u: a motion along x by one pixel's worth changes r by 0.1.
class RampResidual : public testing::Test {
 protected:
  std::vector<float> pixels_ = Ramp();
  ImageSampler<double> sampler_{pixels_.data(), kCamera.width, kCamera.height};

  bool Valid(const SE3d& pose, const ReferencePixel<double>& pixel) const {
    bool valid = false;
    const double residual = Residual(Warp<double>(pose, kCamera), sampler_, pixel, &valid);
    EXPECT_TRUE(valid || residual == 0);
    return valid;
  }
};

TEST_F(RampResidual, IsCurrentMinusReference) {
  const Warp<double> warp(SE3d{{}, {0.2, 0, 0}}, kCamera);
  bool valid = false;
  const double r = Residual<double>(warp, sampler_, {3, 2, 2, 0.25}, &valid);
  EXPECT_TRUE(valid);
  EXPECT_NEAR(r, 0.1 * 4 - 0.25, 1e-7);
}

TEST_F(RampResidual, NeedsFourPixelsAroundTheWarpedOne) {
  const SE3d identity;
  EXPECT_TRUE(Valid({{}, {1e-9, 1e-9, 0}}, {0, 0, 1, 0}));
  EXPECT_TRUE(Valid({{}, {0.04, 0, 0}}, {6, 4, 1, 0}));
  EXPECT_FALSE(Valid(identity, {7, 3, 1, 0}));  // its right neighbour is missing
  EXPECT_FALSE(Valid(identity, {3, 5, 1, 0}));  // its lower neighbour is missing
  EXPECT_FALSE(Valid({{}, {-0.01, 0, 0}}, {0, 3, 1, 0}));
  EXPECT_FALSE(Valid({{}, {0, -0.01, 0}}, {3, 0, 1, 0}));
  EXPECT_FALSE(Valid({{}, {0, 0, -2}}, {3, 3, 1, 0}));
  EXPECT_FALSE(Valid(identity, {3, 3, 0, 0}));
}

TEST_F(RampResidual, JacobianOfAMotionThatIsKnown) {
  const Warp<double> warp(SE3d{}, kCamera);
  const LinearizedResidual<double> l = Linearize<double>(warp, sampler_, {5.5, 2.5, 2, 0});
  ASSERT_TRUE(l.valid);
  // ∂r/∂vx = 0.1·fx/Z; at X = 0.4, ∂r/∂vz = −0.1·fx·X/Z²; about y, u moves by fx·(1 + (X/Z)²).
  EXPECT_NEAR(l.jacobian[3], 0.1 * 10 / 2, 1e-6);
  EXPECT_NEAR(l.jacobian[4], 0, 1e-6);
  EXPECT_NEAR(l.jacobian[5], -0.1 * 10 * 0.4 / 4, 1e-6);
  EXPECT_NEAR(l.jacobian[1], 0.1 * 10 * 1.04, 1e-6);
}

TEST_F(RampResidual, WhatIsNotValidAddsNothing) {
  Sums<double> sums;
  const Warp<double> warp(SE3d{{}, {std::nan(""), 0, 0}}, kCamera);
  sums.Add(Linearize<double>(warp, sampler_, {3, 3, 1, 0.5}));
  EXPECT_EQ(sums.cost.count, 0);
  EXPECT_EQ(sums.cost.squares, 0);
  for (double h : sums.hessian) EXPECT_EQ(h, 0);
  for (double g : sums.gradient) EXPECT_EQ(g, 0);
}

TEST(Sums, AreTheUpperTriangleTheGradientAndTheCost) {
  Sums<double> sums;
  const LinearizedResidual<double> a{2, {1, 2, 3, 4, 5, 6}, 0, true};
  sums.Add(a);
  sums.Add(a);
  int k = 0;
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(sums.gradient[i], 2 * 2 * (i + 1));
    for (int j = i; j < 6; ++j) EXPECT_EQ(sums.hessian[k++], 2 * (i + 1) * (j + 1));
  }
  EXPECT_EQ(k, kHessianSize);
  EXPECT_EQ(sums.cost.squares, 8);
  EXPECT_EQ(sums.cost.count, 2);
}

}  // namespace
}  // namespace silt::tracker::kernel
