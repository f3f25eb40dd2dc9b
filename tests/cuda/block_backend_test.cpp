// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/block_backend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "silt/core/random.h"
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#include "silt/cuda/emulated_backend.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/cpu_backend.h"

// The GPU's backend against the CPU's: on a GPU where there is one, and in every case on the CPU,
// block by block, with the threads of a block in either order.
namespace silt::cuda {
namespace {

using tracker::Backend;
using tracker::NormalEquations;
using tracker::ResidualNorm;

// Odd sizes at the coarser levels, more pixels than one block takes, and a part of one.
constexpr PinholeCamera kCamera{150, 148, 79.5, 57, 161, 118};
const SE3d kPose = SE3d::Exp({{0.02, -0.03, 0.015}, {0.03, 0.02, -0.02}});
constexpr int kLevels = 4;

struct Pictures {
  Image<float> intensity{kCamera.width, kCamera.height}, depth_m{kCamera.width, kCamera.height};
};

// A wavy wall with a board before it and holes in the depth, seen from `camera_from_world`: close
// enough to a picture for residuals, edges and hidden pixels of all kinds.
Pictures Scene(const SE3d& camera_from_world) {
  const SE3d world_from_camera = camera_from_world.Inverse();
  const Vec3d eye = world_from_camera.translation;
  Pictures pictures;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const Vec3d ray = world_from_camera.rotation * kCamera.Unproject(x, y, 1.0);
      const auto hit = [&](double wall_z) { return eye + (wall_z - eye.z) / ray.z * ray; };
      Vec3d p = hit(1.4);
      if (std::abs(p.x) > 0.25 || std::abs(p.y) > 0.2) p = hit(2.5);
      pictures.depth_m(x, y) = (x + 3 * y) % 97 == 0 ? 0 : float((camera_from_world * p).z);
      pictures.intensity(x, y) =
          float(0.5 + 0.2 * std::sin(14 * p.x + 3 * p.z) + 0.2 * std::cos(11 * p.y + 5 * p.x));
    }
  }
  return pictures;
}

struct Pair {
  std::unique_ptr<tracker::ReferencePyramid> reference;
  std::unique_ptr<tracker::CurrentPyramid> current;
  tracker::ImagePair images() const { return {*reference, *current}; }
};

Pair MakePair(const Backend& backend, const tracker::PyramidOptions& options,
              bool with_depth = true) {
  const Pictures reference = Scene({}), current = Scene(kPose);
  return {backend.MakeReference(reference.intensity, reference.depth_m, kCamera, options),
          backend.MakeCurrent(current.intensity, with_depth ? current.depth_m : Image<float>{},
                              options)};
}

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
}

enum class Machine { kForward, kBackward, kGpu };

class BlockBackendOn : public testing::TestWithParam<Machine> {
 protected:
  void SetUp() override {
    if (GetParam() == Machine::kGpu && DeviceList().empty()) GTEST_SKIP() << "no CUDA device";
    block_ = GetParam() == Machine::kGpu       ? MakeCudaBackend()
             : GetParam() == Machine::kForward ? MakeEmulatedBackend(ThreadOrder::kForward)
                                               : MakeEmulatedBackend(ThreadOrder::kBackward);
  }

  std::unique_ptr<const Backend> block_;
  const std::unique_ptr<const Backend> cpu_ = tracker::MakeCpuBackend();
};

INSTANTIATE_TEST_SUITE_P(, BlockBackendOn,
                         testing::Values(Machine::kForward, Machine::kBackward, Machine::kGpu),
                         [](const auto& each) {
                           return each.param == Machine::kForward    ? "CpuForward"
                                  : each.param == Machine::kBackward ? "CpuBackward"
                                                                     : "Gpu";
                         });

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
