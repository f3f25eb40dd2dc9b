// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../analytic_room.h"
#include "cubic_image_sampler.h"
#include "silt/core/random.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/residual.h"

// The Jacobian of the residual against automatic differentiation of the same residual, in double
// precision, through the interpolant that the tracker uses.
namespace silt::tracker::kernel {
namespace {

using Jet = ceres::Jet<double, 6>;

struct JetSampler {
  const float* pixels;
  int width, height;

  Taps<Jet> operator()(const Jet& x, const Jet& y) const {
    const Taps<double> taps = ImageSampler<double>{pixels, width, height}(x.a, y.a);
    return {Jet(taps.v00), Jet(taps.v10), Jet(taps.v01), Jet(taps.v11)};
  }
};

// exp(ξ)·T as a function of ξ, at ξ = 0.
SE3<Jet> Perturbed(const SE3d& pose) {
  const Twist<Jet> xi{{Jet(0, 0), Jet(0, 1), Jet(0, 2)}, {Jet(0, 3), Jet(0, 4), Jet(0, 5)}};
  return SE3<Jet>::Exp(xi) * pose.Cast<Jet>();
}

using Linearizer = LinearizedResidual<double> (*)(const Warp<double>&, const ImageSampler<double>&,
                                                  const ReferencePixel<double>&);

// The largest difference over the pixels of a pair of views, relative to the size of each row of
// the Jacobian; and how many pixels were compared.
struct Comparison {
  double largest = 0;
  int pixels = 0;
};

Comparison CompareWithJets(const SE3d& pose, const Linearizer& linearize) {
  const View reference = RenderRoom({}), current = RenderRoom(pose.Inverse());
  const ImageSampler<double> sampler{current.intensity.data(), 160, 120};
  const JetSampler jet_sampler{current.intensity.data(), 160, 120};
  const Warp<double> warp(pose, kSmallCamera);
  const Warp<Jet> jet_warp(Perturbed(pose), kSmallCamera.Cast<Jet>());
  Comparison result;
  for (int y = 0; y < 120; y += 3) {
    for (int x = 0; x < 160; x += 3) {
      const double z = reference.depth_m(x, y), i = reference.intensity(x, y);
      const LinearizedResidual<double> l = linearize(warp, sampler, {double(x), double(y), z, i});
      bool valid = false;
      const Jet r = Residual<Jet>(jet_warp, jet_sampler,
                                  {Jet(double(x)), Jet(double(y)), Jet(z), Jet(i)}, &valid);
      EXPECT_EQ(valid, l.valid);
      if (!valid) continue;
      ++result.pixels;
      const double scale = std::max(1.0, r.v.norm());
      result.largest = std::max(result.largest, std::abs(r.a - l.residual) / scale);
      for (int k = 0; k < 6; ++k) {
        result.largest = std::max(result.largest, std::abs(r.v[k] - l.jacobian[k]) / scale);
      }
    }
  }
  return result;
}

SE3d RandomPose(int index) {
  const CounterRandom random(7, std::uint64_t(index));
  double xi[6];
  for (int i = 0; i < 6; ++i) xi[i] = 0.2 * (random.Uniform(std::uint64_t(i)) - 0.5);
  return SE3d::Exp({{xi[0], xi[1], xi[2]}, {xi[3], xi[4], xi[5]}});
}

class JacobianAt : public testing::TestWithParam<int> {};

TEST_P(JacobianAt, AgreesWithAutomaticDifferentiation) {
  const Comparison result =
      CompareWithJets(RandomPose(GetParam()), Linearize<double, ImageSampler<double>>);
  EXPECT_GT(result.pixels, 1000);
  EXPECT_LT(result.largest, 1e-10);
}

// 1/Z_c(W) − 1/Z against automatic differentiation of the same.
TEST_P(JacobianAt, OfTheInverseDepthAgreesToo) {
  const SE3d pose = RandomPose(GetParam());
  const View reference = RenderRoom({});
  Image<float> inverse_depth = RenderRoom(pose.Inverse()).depth_m;
  for (float& z : inverse_depth) z = 1 / z;
  const ImageSampler<double> sampler{inverse_depth.data(), 160, 120};
  const JetSampler jet_sampler{inverse_depth.data(), 160, 120};
  const Warp<double> warp(pose, kSmallCamera);
  const Warp<Jet> jet_warp(Perturbed(pose), kSmallCamera.Cast<Jet>());
  int compared = 0;
  for (int y = 0; y < 120; y += 3) {
    for (int x = 0; x < 160; x += 3) {
      const double z = reference.depth_m(x, y);
      const LinearizedResidual<double> l = LinearizeInverseDepth(
          warp, WarpPixel<double>(warp, {double(x), double(y), z, 0}), sampler);
      const WarpedPixel<Jet> warped =
          WarpPixel<Jet>(jet_warp, {Jet(double(x)), Jet(double(y)), Jet(z), Jet(0)});
      const WarpedSample<Jet> current = SampleCurrent(warped, jet_sampler);
      ASSERT_EQ(l.valid, current.valid);
      if (!l.valid) continue;
      ++compared;
      const Jet r = current.sample.value - warped.inverse_z;
      const double scale = std::max(1.0, r.v.norm());
      EXPECT_NEAR(l.residual, r.a, 1e-10 * scale);
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(l.jacobian[k], r.v[k], 1e-10 * scale) << k;
    }
  }
  EXPECT_GT(compared, 1000);
}

// The same residual through either cubic.
TEST_P(JacobianAt, OfCubicInterpolantsAgreesToo) {
  const SE3d pose = RandomPose(GetParam());
  const View reference = RenderRoom({}), current = RenderRoom(pose.Inverse());
  for (const float b : {0.0f, 1.0f}) {
    const float c = (1 - b) / 2;
    const CubicImageSampler<double> sampler{current.intensity, CubicKernel<double>(b, c)};
    const CubicImageSampler<Jet> jet_sampler{current.intensity, CubicKernel<Jet>(b, c)};
    const Warp<double> warp(pose, kSmallCamera);
    const Warp<Jet> jet_warp(Perturbed(pose), kSmallCamera.Cast<Jet>());
    int compared = 0;
    for (int y = 0; y < 120; y += 3) {
      for (int x = 0; x < 160; x += 3) {
        const double z = reference.depth_m(x, y), i = reference.intensity(x, y);
        const LinearizedResidual<double> l =
            Linearize<double>(warp, sampler, {double(x), double(y), z, i});
        bool valid = false;
        const Jet r = Residual<Jet>(jet_warp, jet_sampler,
                                    {Jet(double(x)), Jet(double(y)), Jet(z), Jet(i)}, &valid);
        ASSERT_EQ(l.valid, valid);
        if (!valid) continue;
        ++compared;
        const double scale = std::max(1.0, r.v.norm());
        EXPECT_NEAR(l.residual, r.a, 1e-10 * scale);
        for (int k = 0; k < 6; ++k) EXPECT_NEAR(l.jacobian[k], r.v[k], 1e-10 * scale) << k;
      }
    }
    EXPECT_GT(compared, 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, JacobianAt, testing::Range(0, 5));

TEST(JacobianCheck, AgreesAtTheIdentity) {
  EXPECT_LT(CompareWithJets({}, Linearize<double, ImageSampler<double>>).largest, 1e-10);
}

// Negative twins: what the check must not let pass.
LinearizedResidual<double> WithOneEntryOff(const Warp<double>& warp,
                                           const ImageSampler<double>& sampler,
                                           const ReferencePixel<double>& pixel) {
  LinearizedResidual<double> l = Linearize(warp, sampler, pixel);
  l.jacobian[4] *= 1 + 1e-8;
  return l;
}

LinearizedResidual<double> WithRightUpdates(const Warp<double>& warp,
                                            const ImageSampler<double>& sampler,
                                            const ReferencePixel<double>& pixel) {
  // J by −ω: the rotation taken the wrong way round.
  LinearizedResidual<double> l = Linearize(warp, sampler, pixel);
  for (int k = 0; k < 3; ++k) l.jacobian[k] = -l.jacobian[k];
  return l;
}

LinearizedResidual<double> WithCentralDifferences(const Warp<double>& warp,
                                                  const ImageSampler<double>& sampler,
                                                  const ReferencePixel<double>& pixel) {
  // ∇I from neighbouring samples: not the derivative of the residual that is evaluated.
  LinearizedResidual<double> l = Linearize(warp, sampler, pixel);
  const WarpedPixel<double> warped = WarpPixel(warp, pixel);
  WarpedPixel<double> left = warped, right = warped;
  left.u -= 1;
  right.u += 1;
  const auto a = SampleCurrent(left, sampler), b = SampleCurrent(right, sampler);
  if (!l.valid || !a.valid || !b.valid) return l;
  const double du = 0.5 * (b.sample.value - a.sample.value);
  l.jacobian[3] = warp.camera.fx * du * warped.inverse_z;
  return l;
}

TEST(JacobianCheck, CorruptedJacobiansFail) {
  EXPECT_GT(CompareWithJets(RandomPose(1), WithOneEntryOff).largest, 1e-10);
  EXPECT_GT(CompareWithJets(RandomPose(1), WithRightUpdates).largest, 1e-3);
  EXPECT_GT(CompareWithJets(RandomPose(1), WithCentralDifferences).largest, 1e-4);
}

}  // namespace
}  // namespace silt::tracker::kernel
