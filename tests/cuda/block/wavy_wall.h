// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "silt/cuda/block/emulated_backend.h"
#include "silt/tracker/cpu_backend.h"
#ifdef SILT_HAVE_CUDA
#include "silt/cuda/cuda_backend.h"
#include "silt/cuda/devices.h"
#endif

// What the tests of the GPU's backend look at, and the machines that they run on: a GPU where there
// is one, and in every case the CPU, block by block, with the threads of a block in either order.
namespace silt::cuda {

// Odd sizes at the coarser levels, more pixels than one block takes, and a part of one.
inline constexpr PinholeCamera kCamera{150, 148, 79.5, 57, 161, 118};
inline const SE3d kPose = SE3d::Exp({{0.02, -0.03, 0.015}, {0.03, 0.02, -0.02}});
inline constexpr int kLevels = 4;

struct Pictures {
  Image<float> intensity{kCamera.width, kCamera.height}, depth_m{kCamera.width, kCamera.height};
};

// A wavy wall with a board before it and holes in the depth, seen from `camera_from_world`: close
// enough to a picture for residuals, edges and hidden pixels of all kinds.
inline Pictures Scene(const SE3d& camera_from_world, bool with_board = true) {
  const SE3d world_from_camera = camera_from_world.Inverse();
  const Vec3d eye = world_from_camera.translation;
  Pictures pictures;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const Vec3d ray = world_from_camera.rotation * kCamera.Unproject(x, y, 1.0);
      const auto hit = [&](double wall_z) { return eye + (wall_z - eye.z) / ray.z * ray; };
      Vec3d p = hit(1.4);
      if (!with_board || std::abs(p.x) > 0.25 || std::abs(p.y) > 0.2) p = hit(2.5);
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

inline Pair MakePair(const tracker::Backend& backend, const tracker::PyramidOptions& options,
                     bool with_depth = true, bool with_board = true) {
  const Pictures reference = Scene({}, with_board), current = Scene(kPose, with_board);
  return {backend.MakeReference(reference.intensity, reference.depth_m, kCamera, options),
          backend.MakeCurrent(current.intensity, with_depth ? current.depth_m : Image<float>{},
                              options)};
}

enum class Machine { kForward, kBackward, kGpu };

// Null where this machine has no GPU, or this build no code for one.
inline std::unique_ptr<const tracker::Backend> MakeBackendOn(Machine machine) {
  if (machine == Machine::kForward) return MakeEmulatedBackend(ThreadOrder::kForward);
  if (machine == Machine::kBackward) return MakeEmulatedBackend(ThreadOrder::kBackward);
#ifdef SILT_HAVE_CUDA
  if (WhyNoUsableDevice().empty()) return MakeCudaBackend();
#endif
  return nullptr;
}

class BackendTest : public testing::TestWithParam<Machine> {
 protected:
  void SetUp() override {
    block_ = MakeBackendOn(GetParam());
    if (!block_) GTEST_SKIP() << "no CUDA device that serves, or built without nvcc";
  }

  std::unique_ptr<const tracker::Backend> block_;
  const std::unique_ptr<const tracker::Backend> cpu_ = tracker::MakeCpuBackend();
};

inline std::string MachineName(const testing::TestParamInfo<Machine>& each) {
  return each.param == Machine::kForward    ? "CpuForward"
         : each.param == Machine::kBackward ? "CpuBackward"
                                            : "Gpu";
}

inline void PrintTo(Machine machine, std::ostream* out) { *out << MachineName({machine, 0}); }

#define INSTANTIATE_BACKENDS(Suite) \
  INSTANTIATE_TEST_SUITE_P(         \
      , Suite, testing::Values(Machine::kForward, Machine::kBackward, Machine::kGpu), MachineName)

}  // namespace silt::cuda
