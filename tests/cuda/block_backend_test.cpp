// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block_backend.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "silt/core/color.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/residual.h"
#include "wavy_wall.h"

// The GPU's backend against the CPU's.
namespace silt::cuda {
namespace {

using tracker::Backend;
using tracker::NormalEquations;
using tracker::ResidualNorm;

ResidualNorm Robust(bool use_depth) {
  ResidualNorm norm;
  norm.intensity = {8.0 / 255, 0.02, 1 / (0.01 * 0.01)};
  norm.inverse_depth = {0, 0.01, 1 / (0.004 * 0.004)};
  norm.use_depth = use_depth;
  return norm;
}

// Σ|J_i·r| ≤ √(H_ii·Σr²): the scale of a gradient's rounding errors, which b itself, near the
// optimum, is not.
void ExpectNear(const NormalEquations& block, const NormalEquations& cpu) {
  EXPECT_EQ(block.cost.pixels, cpu.cost.pixels);
  EXPECT_NEAR(block.cost.sum, cpu.cost.sum, 1e-6 * cpu.cost.sum);
  EXPECT_NEAR(block.cost.squares, cpu.cost.squares, 1e-6 * cpu.cost.squares);
  EXPECT_EQ(block.intensity.count, cpu.intensity.count);
  EXPECT_NEAR(block.intensity.squares, cpu.intensity.squares, 1e-6 * cpu.intensity.squares);
  EXPECT_EQ(block.inverse_depth.count, cpu.inverse_depth.count);
  EXPECT_NEAR(block.inverse_depth.squares, cpu.inverse_depth.squares,
              1e-6 * cpu.inverse_depth.squares);
  double diagonal[6];
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) diagonal[i] = cpu.hessian[k];
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      EXPECT_NEAR(block.hessian[k], cpu.hessian[k], 1e-5 * std::sqrt(diagonal[i] * diagonal[j]));
    }
    EXPECT_NEAR(block.gradient[i], cpu.gradient[i],
                1e-6 * std::sqrt(diagonal[i] * 2 * cpu.cost.sum));
  }
  double scatter[6];
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) scatter[i] = cpu.scatter[k];
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      EXPECT_NEAR(block.scatter[k], cpu.scatter[k], 1e-4 * std::sqrt(scatter[i] * scatter[j]));
    }
  }
}

class BlockBackendOn : public BackendTest {};
INSTANTIATE_BACKENDS(BlockBackendOn);

TEST_P(BlockBackendOn, PyramidsMeasureWhatTheCpusDo) {
  for (const int margin_px : {0, 1, 2, 5}) {
    const tracker::PyramidOptions options{kLevels, margin_px, true};
    const Pair block = MakePair(*block_, options), cpu = MakePair(*cpu_, options);
    ASSERT_EQ(block.reference->levels().size(), cpu.reference->levels().size());
    for (int level = 0; level < kLevels; ++level) {
      EXPECT_EQ(block.reference->levels()[level].measured_pixels,
                cpu.reference->levels()[level].measured_pixels);
      EXPECT_EQ(block.reference->levels()[level].camera.cx,
                cpu.reference->levels()[level].camera.cx);
      EXPECT_GT(cpu.reference->levels()[level].measured_pixels, 0);
    }
  }
}

TEST_P(BlockBackendOn, EquationsAreTheCpusAtEveryLevelAndOfEveryNorm) {
  const tracker::PyramidOptions options{kLevels, 2, true};
  const Pair block = MakePair(*block_, options), cpu = MakePair(*cpu_, options);
  for (int level = 0; level < kLevels; ++level) {
    for (const ResidualNorm& norm : {ResidualNorm{}, Robust(false), Robust(true)}) {
      const NormalEquations expected = cpu_->Linearize(cpu.images(), level, kPose, norm);
      EXPECT_GT(expected.cost.pixels, 20);
      ExpectNear(block_->Linearize(block.images(), level, kPose, norm), expected);
    }
  }
}

// Σ|J_i·r| over all pixels: what a gradient that all but cancels is a small rest of.
std::array<double, 6> AbsoluteGradient(const SE3d& pose) {
  namespace kernel = tracker::kernel;
  const Pictures reference = Scene({}), current = Scene(kPose);
  const kernel::Warp<double> warp(pose, kCamera);
  const kernel::ImageSampler<double> sampler{current.intensity.data(), kCamera.width,
                                             kCamera.height};
  std::array<double, 6> sum{};
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const auto r = kernel::Linearize(
          warp, sampler,
          {double(x), double(y), reference.depth_m(x, y), reference.intensity(x, y)});
      for (std::size_t i = 0; i < 6; ++i) sum[i] += std::abs(r.jacobian[i] * r.residual);
    }
  }
  return sum;
}

TEST_P(BlockBackendOn, TheGradientErrsByAMillionthOfWhatCancelsInIt) {
  const Pair block = MakePair(*block_, {kLevels, 0, false});
  const Pair cpu = MakePair(*cpu_, {kLevels, 0, false});
  for (const SE3d& pose : {kPose, SE3d::Exp({{0.002, 0, 0}, {0, 0.003, 0}}) * kPose}) {
    const std::array<double, 6> absolute = AbsoluteGradient(pose);
    const NormalEquations ours = block_->Linearize(block.images(), 0, pose);
    const NormalEquations theirs = cpu_->Linearize(cpu.images(), 0, pose);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_GT(absolute[i], 0);
      EXPECT_LE(std::abs(ours.gradient[i] - theirs.gradient[i]), 1e-6 * absolute[i]) << i;
    }
  }
}

TEST_P(BlockBackendOn, CostIsThatOfTheEquations) {
  const Pair block = MakePair(*block_, {kLevels, 0, false});
  for (int level = 0; level < kLevels; ++level) {
    EXPECT_EQ(block_->Cost(block.images(), level, kPose),
              block_->Linearize(block.images(), level, kPose).cost);
  }
}

TEST_P(BlockBackendOn, HidesWhatTheCpuHides) {
  for (const bool with_depth : {false, true}) {
    const tracker::PyramidOptions options{kLevels, 0, false};
    const Pair block = MakePair(*block_, options, with_depth);
    const Pair cpu = MakePair(*cpu_, options, with_depth);
    const SE3d pose = SE3d::Exp({{0, 0, 0}, {0.15, 0, 0}}) * kPose;
    for (int level = 0; level < kLevels; ++level) {
      const auto visible = block_->WithoutHidden(block.images(), level, pose);
      const auto expected = cpu_->WithoutHidden(cpu.images(), level, pose);
      const NormalEquations all = cpu_->Linearize(cpu.images(), level, pose);
      const NormalEquations less = cpu_->Linearize({*expected, *cpu.current}, level, pose);
      if (level == 0) {
        EXPECT_LT(less.cost.pixels, all.cost.pixels);
      }
      ExpectNear(block_->Linearize({*visible, *block.current}, level, pose), less);
    }
  }
}

TEST_P(BlockBackendOn, AlignsAsTheCpu) {
  for (const tracker::TrackerOptions& preset :
       {tracker::PaperPreset(), tracker::AccuratePreset(), tracker::FastPreset()}) {
    tracker::AlignmentOptions options = preset.alignment;
    options.max_iterations = {40, 20, 20, 20};
    const Pair block = MakePair(*block_, options.Pyramids());
    const Pair cpu = MakePair(*cpu_, options.Pyramids());
    const auto expected = tracker::Align(*cpu_, cpu.images(), {}, options);
    const auto aligned = tracker::Align(*block_, block.images(), {}, options);
    ASSERT_TRUE(expected.ok) << expected.failure;
    ASSERT_TRUE(aligned.ok) << aligned.failure;
    const Twistd apart =
        (aligned.current_from_reference * expected.current_from_reference.Inverse()).Log();
    // What lies across an edge stays in the squares of the paper, and leaves their minimum so flat
    // that their rounding shows.
    const double apart_m = options.robust() ? 1e-6 : 5e-6, error_m = options.robust() ? 1e-4 : 1e-2;
    EXPECT_LT(Norm(apart.omega), 1e-6);
    EXPECT_LT(Norm(apart.v), apart_m);
    EXPECT_LT(Norm((aligned.current_from_reference * kPose.Inverse()).Log().v), error_m);
  }
}

// From a tracker's frames: colours converted by the backend, and a keyframe of what was current.
TEST_P(BlockBackendOn, ColoursAndKeyframesOfThemAreTheCpus) {
  const Pictures pictures = Scene(kPose);
  Image<Rgb8> rgb(kCamera.width, kCamera.height);
  for (int y = 0; y < rgb.height(); ++y) {
    for (int x = 0; x < rgb.width(); ++x) {
      const auto value = std::uint8_t(255 * pictures.intensity(x, y));
      rgb(x, y) = {value, std::uint8_t(255 - value), std::uint8_t(value / 2)};
    }
  }
  const Image<float> gray = GrayFromRgb(rgb);
  for (const bool with_depth : {false, true}) {
    const tracker::PyramidOptions options{kLevels, 2, true};
    const Image<float> depth_m = with_depth ? pictures.depth_m : Image<float>{};
    const auto current = block_->MakeCurrentOfColour(rgb, depth_m, options);
    const auto of_gray = block_->MakeCurrent(gray, depth_m, options);
    ASSERT_TRUE(current);
    const auto keyframe =
        block_->MakeReferenceOfCurrent(*current, pictures.depth_m, kCamera, options);
    const auto made_anew = block_->MakeReference(gray, pictures.depth_m, kCamera, options);
    ASSERT_TRUE(keyframe);
    EXPECT_EQ(current->has_depth(), with_depth);
    for (int level = 0; level < kLevels; ++level) {
      EXPECT_EQ(keyframe->levels()[level].measured_pixels,
                made_anew->levels()[level].measured_pixels);
      const SE3d pose = SE3d::Exp({{0.01, 0, 0}, {0, 0.01, 0}});
      EXPECT_EQ(block_->Linearize({*keyframe, *current}, level, pose, Robust(with_depth)),
                block_->Linearize({*made_anew, *of_gray}, level, pose, Robust(with_depth)));
    }
  }
}

TEST_P(BlockBackendOn, AnImageWithoutFourPixelsInASquareHasNoResiduals) {
  const PinholeCamera camera{1, 1, 0, 0, 1, 3};
  const Image<float> intensity(1, 3, 0.5f), depth_m(1, 3, 1.0f);
  const auto reference = block_->MakeReference(intensity, depth_m, camera, {2, 0, false});
  const auto current = block_->MakeCurrent(intensity, {}, {2, 0, false});
  EXPECT_EQ(reference->levels()[0].measured_pixels, 3);
  EXPECT_EQ(reference->levels()[1].measured_pixels, 0);
  EXPECT_EQ(block_->Linearize({*reference, *current}, 0, {}), NormalEquations{});
  EXPECT_EQ(block_->Cost({*reference, *current}, 1, {}), tracker::PhotometricCost{});
}

// No thread reads in a phase what another one writes in it: bits do not depend on who comes first.
TEST(EmulatedBackend, TheOrderOfThreadsChangesNoBit) {
  const auto forward = MakeEmulatedBackend(ThreadOrder::kForward);
  const auto backward = MakeEmulatedBackend(ThreadOrder::kBackward);
  const tracker::PyramidOptions options{kLevels, 2, true};
  const Pair one = MakePair(*forward, options), other = MakePair(*backward, options);
  for (int level = 0; level < kLevels; ++level) {
    EXPECT_EQ(forward->Linearize(one.images(), level, kPose, Robust(true)),
              backward->Linearize(other.images(), level, kPose, Robust(true)));
    const auto seen = forward->WithoutHidden(one.images(), level, kPose);
    const auto too = backward->WithoutHidden(other.images(), level, kPose);
    EXPECT_EQ(forward->Cost({*seen, *one.current}, level, kPose),
              backward->Cost({*too, *other.current}, level, kPose));
  }
}

TEST(CudaBackend, WithoutADeviceIsOneClearLine) {
  if (!DeviceList().empty()) GTEST_SKIP() << "there is a CUDA device";
  try {
    MakeCudaBackend();
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--backend cuda: no CUDA device is at hand; use --backend cpu");
  }
}

}  // namespace
}  // namespace silt::cuda
