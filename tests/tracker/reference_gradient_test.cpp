// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "analytic_room.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/cpu_reduction.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/sums.h"

// Jacobians of gradients that the keyframe has.
namespace silt::tracker {
namespace {

const SE3d kMotion = SE3d::Exp({{0.02, -0.03, 0.01}, {0.04, -0.02, 0.03}});

struct Pictures {
  View reference = RenderRoom({}), current = RenderRoom(kMotion.Inverse());

  NormalEquations Equations(double share, SimdLevel level = BestSimdLevel()) const {
    ResidualNorm norm;
    norm.reference_gradient = share;
    return CpuReduction(level).Equations(
        {kSmallCamera, reference.intensity, reference.depth_m, current.intensity}, kMotion, norm);
  }

  // In double precision, from the definition.
  kernel::Sums<double> Expected(double share) const {
    const kernel::Warp<double> warp(kMotion, kSmallCamera);
    const kernel::ImageSampler<double> sampler{current.intensity.data(), kSmallCamera.width,
                                               kSmallCamera.height};
    kernel::Sums<double> sums;
    const Image<float>& i = reference.intensity;
    for (int y = 0; y < i.height(); ++y) {
      for (int x = 0; x < i.width(); ++x) {
        const auto warped = kernel::WarpPixel<double>(
            warp, {double(x), double(y), reference.depth_m(x, y), i(x, y)});
        auto sample = kernel::SampleCurrent(warped, sampler);
        if (x > 0 && y > 0 && x + 1 < i.width() && y + 1 < i.height()) {
          const double du = 0.5 * (double(i(x + 1, y)) - i(x - 1, y));
          const double dv = 0.5 * (double(i(x, y + 1)) - i(x, y - 1));
          sample.sample.du = (1 - share) * sample.sample.du + share * du;
          sample.sample.dv = (1 - share) * sample.sample.dv + share * dv;
        }
        sums.Add(kernel::LinearizeIntensity<double>(warp, warped, sample, i(x, y)));
      }
    }
    return sums;
  }
};

TEST(ReferenceGradient, TakesItsShareOfTheJacobian) {
  const Pictures pictures;
  for (const double share : {0.0, 0.5, 1.0}) {
    const NormalEquations equations = pictures.Equations(share);
    const kernel::Sums<double> expected = pictures.Expected(share);
    EXPECT_EQ(double(equations.cost.pixels), expected.cost.count);
    EXPECT_NEAR(equations.cost.squares, expected.cost.squares, 1e-4 * expected.cost.squares);
    for (int k = 0; k < 21; ++k) {
      EXPECT_NEAR(equations.hessian[k], expected.hessian[k], 1e-5 * expected.hessian[0])
          << share << " " << k;
    }
  }
  EXPECT_GT(std::abs(pictures.Expected(1).hessian[0] / pictures.Expected(0).hessian[0] - 1), 1e-3);
}

TEST(ReferenceGradient, HasTheSameBitsAtEverySimdLevel) {
  const Pictures pictures;
  const NormalEquations expected = pictures.Equations(0.5);
  for (const SimdLevel level : SupportedSimdLevels()) {
    EXPECT_EQ(pictures.Equations(0.5, level), expected);
  }
}

// Whichever gradients it goes by, the residuals are the same, and with them the pose.
TEST(ReferenceGradient, LeadsToTheSamePose) {
  const Pictures pictures;
  const auto backend = MakeCpuBackend();
  AlignmentOptions options = AccuratePreset().alignment;
  options.max_iterations = {20, 20, 20};
  options.depth_residual = options.use_current_depth = false;
  const auto reference = backend->MakeReference(
      pictures.reference.intensity, pictures.reference.depth_m, kSmallCamera, options.Pyramids());
  const auto current = backend->MakeCurrent(pictures.current.intensity, {}, options.Pyramids());
  for (const double share : {0.0, 0.5, 1.0}) {
    options.reference_gradient = share;
    const AlignmentResult result = Align(*backend, {*reference, *current}, {}, options);
    ASSERT_TRUE(result.ok) << result.failure;
    EXPECT_LT(Norm((result.current_from_reference * kMotion.Inverse()).Log().v), 1e-3) << share;
  }
}

// And the norms: each finds it, with the same bits at every level.
TEST(RobustLosses, FindTheSamePose) {
  const Pictures pictures;
  for (const RobustLoss loss :
       {RobustLoss::kGemanMcClure, RobustLoss::kHuber, RobustLoss::kTukey, RobustLoss::kStudentT}) {
    AlignmentOptions options = AccuratePreset().alignment;
    options.max_iterations = {20, 20, 20};
    options.robust_loss = loss;
    SE3d first;
    for (const SimdLevel level : SupportedSimdLevels()) {
      const auto backend = MakeCpuBackend(level);
      const auto reference =
          backend->MakeReference(pictures.reference.intensity, pictures.reference.depth_m,
                                 kSmallCamera, options.Pyramids());
      const auto current = backend->MakeCurrent(pictures.current.intensity,
                                                pictures.current.depth_m, options.Pyramids());
      const AlignmentResult result = Align(*backend, {*reference, *current}, {}, options);
      ASSERT_TRUE(result.ok) << result.failure;
      const SE3d& found = result.current_from_reference;
      EXPECT_LT(Norm((found * kMotion.Inverse()).Log().v), 3e-4) << int(loss);
      if (level == SupportedSimdLevels().front()) first = found;
      EXPECT_EQ(Norm(found.Log().v - first.Log().v), 0) << int(loss);
      EXPECT_EQ(Norm(found.Log().omega - first.Log().omega), 0) << int(loss);
    }
  }
}

}  // namespace
}  // namespace silt::tracker
