// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block/block_backend.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/depth_edges.h"
#include "silt/tracker/kernel/image_sampler.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/kernel/robust_norm.h"
#include "silt/tracker/keyframe_tracker.h"
#include "silt/tracker/pixel_sums.h"
#include "wavy_wall.h"

// The GPU's backend against the CPU's.
namespace silt::cuda {
namespace {

using tracker::Backend;
using tracker::NormalEquations;
using tracker::ResidualNorm;
using tracker::RobustLoss;

ResidualNorm Robust(bool use_depth, RobustLoss loss = RobustLoss::kGemanMcClure) {
  ResidualNorm norm;
  norm.intensity = {8.0 / 255, 0.02, 1 / (0.01 * 0.01)};
  norm.inverse_depth = {0, 0.01, 1 / (0.004 * 0.004)};
  norm.intensity.loss = norm.inverse_depth.loss = loss;
  norm.use_depth = use_depth;
  return norm;
}

using Gradient = std::array<double, 6>;

// Both are near where b differs by no more than a millionth of `scale`, and as many pixels count
// but for `stray` at a border, each of which may be a thousandth of a sum.
void ExpectNear(const NormalEquations& block, const NormalEquations& cpu, const Gradient& scale,
                int stray = 0) {
  const auto difference = block.cost.pixels - cpu.cost.pixels;
  EXPECT_LE(std::abs(difference), stray);
  const double astray = 1e-3 * double(std::abs(difference));
  EXPECT_NEAR(block.cost.sum, cpu.cost.sum, (1e-6 + astray) * cpu.cost.sum);
  EXPECT_NEAR(block.cost.squares, cpu.cost.squares, (1e-6 + astray) * cpu.cost.squares);
  EXPECT_NEAR(block.intensity.count, cpu.intensity.count, stray);
  EXPECT_NEAR(block.intensity.squares, cpu.intensity.squares,
              (1e-6 + astray) * cpu.intensity.squares);
  EXPECT_NEAR(block.inverse_depth.count, cpu.inverse_depth.count, stray);
  EXPECT_NEAR(block.inverse_depth.squares, cpu.inverse_depth.squares,
              (1e-6 + astray) * cpu.inverse_depth.squares);
  double diagonal[6];
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) diagonal[i] = cpu.hessian[k];
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      EXPECT_NEAR(block.hessian[k], cpu.hessian[k],
                  (1e-5 + astray) * std::sqrt(diagonal[i] * diagonal[j]));
    }
    EXPECT_GT(scale[i], 0);
    EXPECT_NEAR(block.gradient[i], cpu.gradient[i], (1e-6 + astray) * scale[i]) << i;
  }
  double scatter[6];
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) scatter[i] = cpu.scatter[k];
  for (int i = 0, k = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j, ++k) {
      EXPECT_NEAR(block.scatter[k], cpu.scatter[k],
                  (1e-4 + astray) * std::sqrt(scatter[i] * scatter[j]));
    }
  }
}

// √(H_ii·Σr²) ≥ Σ|J_i·r|.
Gradient LargestGradient(const NormalEquations& equations) {
  Gradient largest{};
  for (int i = 0, k = 0; i < 6; k += 6 - i, ++i) {
    largest[i] = std::sqrt(equations.hessian[k] * 2 * equations.cost.sum);
  }
  return largest;
}

// One level of MakePair's images as a backend prepares them.
struct HostLevel {
  PinholeCamera camera;
  Pictures reference, current;
  Image<float> inverse_depth;  // of the current image
};

// The next coarser level, before depth edges are left out.
HostLevel Halved(const HostLevel& fine) {
  const auto halved = [](const Pictures& pictures) {
    return Pictures{HalvedIntensity(pictures.intensity), HalvedDepth(pictures.depth_m)};
  };
  return {fine.camera.Halved(), halved(fine.reference), halved(fine.current), {}};
}

HostLevel WithoutEdges(HostLevel level, int margin_px) {
  const Image<float> whole_m = level.current.depth_m;
  level.reference.depth_m = tracker::WithoutDepthEdges(level.reference.depth_m, margin_px);
  level.current.depth_m = tracker::WithoutDepthEdges(whole_m, margin_px);
  level.inverse_depth = level.current.depth_m;
  for (std::size_t i = 0; i < whole_m.size(); ++i) {
    const float z = level.current.depth_m.data()[i];
    if (z == 0 && whole_m.data()[i] != 0) level.current.intensity.data()[i] = NAN;
    level.inverse_depth.data()[i] = z > 0 ? 1 / z : NAN;
  }
  return level;
}

std::vector<HostLevel> HostLevels(const tracker::PyramidOptions& options) {
  HostLevel whole{kCamera, Scene({}), Scene(kPose), {}};
  std::vector<HostLevel> levels;
  for (int i = 0; i < options.levels; ++i, whole = Halved(whole)) {
    const int margin_px = options.depth_edge_margin_px;
    levels.push_back(WithoutEdges(whole, i == 0 ? margin_px : (margin_px + 1) / 2));
  }
  return levels;
}

// Σ|J_i·r| over all residuals, in double precision: what a gradient that all but cancels is a small
// rest of.
Gradient AbsoluteGradient(const HostLevel& level, const SE3d& pose, const ResidualNorm& norm) {
  using Norm = kernel::RobustNorm<double>;
  const auto [width, height] = std::pair(level.camera.width, level.camera.height);
  const kernel::Warp<double> warp(pose, level.camera);
  const kernel::ImageSampler<double> intensity{level.current.intensity.data(), width, height};
  const kernel::ImageSampler<double> inverse_depth{level.inverse_depth.data(), width, height};
  Gradient sum{};
  const auto add = [&](kernel::LinearizedResidual<double> r, const tracker::RobustBounds& bounds) {
    if (norm.robust()) kernel::Weigh(tracker::FloatNorm<Norm>(bounds), &r);
    for (std::size_t i = 0; i < 6; ++i) sum[i] += std::abs(r.jacobian[i] * r.residual);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto warped =
          kernel::WarpPixel<double>(warp, {double(x), double(y), level.reference.depth_m(x, y), 0});
      add(kernel::LinearizeIntensity<double>(warp, warped, intensity,
                                             level.reference.intensity(x, y)),
          norm.intensity);
      if (!norm.use_depth) continue;
      add(kernel::LinearizeInverseDepth(warp, warped, inverse_depth), norm.inverse_depth);
    }
  }
  return sum;
}

class BlockBackendOn : public BackendTest {
 protected:
  // A GPU rounds divisions and floors otherwise: a pixel at a border may land beyond it.
  static int Stray() { return GetParam() == Machine::kGpu ? 3 : 0; }
};
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
  for (const int margin_px : {0, 2}) {
    const tracker::PyramidOptions options{kLevels, margin_px, true};
    const Pair block = MakePair(*block_, options), cpu = MakePair(*cpu_, options);
    const std::vector<HostLevel> levels = HostLevels(options);
    for (int level = 0; level < kLevels; ++level) {
      for (const ResidualNorm& norm :
           {ResidualNorm{}, Robust(false), Robust(true), Robust(true, RobustLoss::kHuber),
            Robust(true, RobustLoss::kTukey), Robust(true, RobustLoss::kStudentT)}) {
        for (const SE3d& pose : {kPose, SE3d::Exp({{0.002, 0, 0}, {0, 0.003, 0}}) * kPose}) {
          SCOPED_TRACE(testing::Message() << "level " << level << ", margin " << margin_px);
          const NormalEquations expected = cpu_->Linearize(cpu.images(), level, pose, norm);
          EXPECT_GT(expected.cost.pixels, 20);
          ExpectNear(block_->Linearize(block.images(), level, pose, norm), expected,
                     AbsoluteGradient(levels[level], pose, norm), Stray());
        }
      }
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
      ExpectNear(block_->Linearize({*visible, *block.current}, level, pose), less,
                 LargestGradient(less), Stray());
    }
  }
}

// In so small a picture, what lies across the board's edge leaves the squares' minimum so flat that
// their rounding shows: they are told by the wall alone.
TEST_P(BlockBackendOn, AlignsAsTheCpu) {
  for (const tracker::TrackerOptions& preset :
       {tracker::PaperPreset(), tracker::AccuratePreset(), tracker::FastPreset()}) {
    tracker::AlignmentOptions options = preset.alignment;
    options.max_iterations = {40, 20, 20, 20};
    const bool with_board = options.robust();
    const Pair block = MakePair(*block_, options.Pyramids(), true, with_board);
    const Pair cpu = MakePair(*cpu_, options.Pyramids(), true, with_board);
    const auto expected = tracker::Align(*cpu_, cpu.images(), {}, options);
    const auto aligned = tracker::Align(*block_, block.images(), {}, options);
    ASSERT_TRUE(expected.ok) << expected.failure;
    ASSERT_TRUE(aligned.ok) << aligned.failure;
    const Twistd apart =
        (aligned.current_from_reference * expected.current_from_reference.Inverse()).Log();
    EXPECT_LT(Norm(apart.omega), 1e-6);
    EXPECT_LT(Norm(apart.v), 1e-6);
    EXPECT_LT(Norm((aligned.current_from_reference * kPose.Inverse()).Log().v),
              with_board ? 1e-4 : 1e-3);
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

// Of a GPU, no more than what has passed on the host; emulated, there is none.
TEST_P(BlockBackendOn, AClockTellsWhatTheDeviceTook) {
  const Pair pair = MakePair(*block_, {kLevels, 2, true});
  const auto begin = std::chrono::steady_clock::now();
  const auto clock = block_->StartClock();
  ASSERT_TRUE(clock);
  (void)block_->Linearize(pair.images(), 0, kPose, Robust(true));
  const double milliseconds = clock->Milliseconds();
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(milliseconds, passed.count());
  if (GetParam() == Machine::kGpu) {
    EXPECT_GT(milliseconds, 0);
  } else {
    EXPECT_EQ(milliseconds, 0);
  }
  EXPECT_FALSE(cpu_->StartClock());
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

TEST_P(BlockBackendOn, ATrackerWithTooManyJointKeyframesIsRefused) {
  const std::shared_ptr<const tracker::Backend> backend = std::move(block_);
  tracker::TrackerOptions options = tracker::AccuratePreset();
  options.keyframes.joint = 4;
  EXPECT_NO_THROW(tracker::KeyframeTracker(kCamera, options, backend, nullptr));
  options.keyframes.joint = 5;
  EXPECT_THROW(tracker::KeyframeTracker(kCamera, options, backend, nullptr), Error);
}

TEST_P(BlockBackendOn, WhatItLacksIsRefusedByName) {
  tracker::AlignmentOptions options = tracker::AccuratePreset().alignment;
  EXPECT_NO_THROW(block_->CheckHas(options));
  EXPECT_NO_THROW(block_->CheckHas(options, 4));
  EXPECT_THROW(block_->CheckHas(options, 5), Error);
  EXPECT_NO_THROW(cpu_->CheckHas(options, 5));
  options.interpolant = tracker::Interpolant::kCatmullRom;
  try {
    block_->CheckHas(options);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("alignment.interpolant: backend ", 0), 0u);
  }
  EXPECT_NO_THROW(cpu_->CheckHas(options));
  options.interpolant = tracker::Interpolant::kBilinear;
  options.affine_brightness = true;
  EXPECT_THROW(block_->CheckHas(options), Error);
  EXPECT_NO_THROW(cpu_->CheckHas(options));
  options.affine_brightness = false;
  options.reference_gradient = 0.5;
  EXPECT_THROW(block_->CheckHas(options), Error);
  EXPECT_NO_THROW(cpu_->CheckHas(options));
}

}  // namespace
}  // namespace silt::cuda
