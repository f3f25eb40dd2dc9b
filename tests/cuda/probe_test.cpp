// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/probe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/cuda/devices.h"
#include "silt/tracker/kernel/image_sampler.h"

namespace silt::cuda {
namespace {

namespace kernel = tracker::kernel;

constexpr PinholeCamera kCamera{60, 60, 39.5, 29.5, 80, 60};
const SE3d kPose = SE3d::Exp({{0.05, -0.04, 0.03}, {0.1, 0.05, -0.1}});

Image<float> Waves() {
  Image<float> image(kCamera.width, kCamera.height);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image(x, y) = 0.5f + 0.3f * std::sin(0.3f * float(x)) * std::cos(0.2f * float(y));
    }
  }
  return image;
}

// Every pixel, some without a depth.
template <typename T>
std::vector<kernel::ReferencePixel<T>> Pixels() {
  const CounterRandom random(3);
  std::vector<kernel::ReferencePixel<T>> pixels;
  for (int i = 0; i < kCamera.width * kCamera.height; ++i) {
    const double depth = i % 17 == 0 ? 0 : 1 + 2 * random.Uniform(std::uint64_t(2 * i));
    pixels.push_back({T(i % kCamera.width), T(i / kCamera.width), T(depth),
                      T(random.Uniform(std::uint64_t(2 * i + 1)))});
  }
  return pixels;
}

template <typename T>
kernel::LinearizedResidual<T> OnTheCpu(const Image<float>& image,
                                       const kernel::ReferencePixel<T>& pixel) {
  const kernel::Warp<T> warp{kernel::Warp<double>(kPose, kCamera)};
  const kernel::ImageSampler<T> sampler{image.data(), image.width(), image.height()};
  return kernel::Linearize(warp, sampler, pixel);
}

template <typename T>
class ProbeOf : public testing::Test {
 protected:
  void SetUp() override {
    if (DeviceList().empty()) GTEST_SKIP() << "no CUDA device";
  }
};

using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(ProbeOf, Scalars);

// Without fused multiply-adds the two differ by no more than how they divide and take floors.
TYPED_TEST(ProbeOf, EachPixelAgreesWithTheCpu) {
  using T = TypeParam;
  const Image<float> image = Waves();
  const std::vector<kernel::ReferencePixel<T>> pixels = Pixels<T>();
  const ProbeResult<T> result = Probe<T>({image, kCamera, kPose, pixels});
  ASSERT_EQ(result.residuals.size(), pixels.size());
  const double tolerance = sizeof(T) == 4 ? 1e-4 : 1e-12;
  int valid = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const kernel::LinearizedResidual<T> cpu = OnTheCpu(image, pixels[i]);
    const kernel::LinearizedResidual<T>& gpu = result.residuals[i];
    ASSERT_EQ(gpu.valid, cpu.valid) << i;
    EXPECT_NEAR(gpu.residual, cpu.residual, tolerance) << i;
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(gpu.jacobian[k], cpu.jacobian[k], tolerance * 60) << i;
    valid += cpu.valid ? 1 : 0;
  }
  EXPECT_GT(valid, 1000);
}

TYPED_TEST(ProbeOf, SumsAgreeWithTheCpuAndRepeat) {
  using T = TypeParam;
  const Image<float> image = Waves();
  const std::vector<kernel::ReferencePixel<T>> pixels = Pixels<T>();
  const ProbeResult<T> once = Probe<T>({image, kCamera, kPose, pixels});
  const ProbeResult<T> again = Probe<T>({image, kCamera, kPose, pixels});
  kernel::Sums<T> cpu;
  for (const auto& pixel : pixels) cpu.Add(OnTheCpu(image, pixel));
  const double tolerance = sizeof(T) == 4 ? 1e-4 : 1e-12;
  EXPECT_EQ(once.sums.cost.count, cpu.cost.count);
  EXPECT_NEAR(once.sums.cost.squares, cpu.cost.squares, tolerance * cpu.cost.squares);
  for (int i = 0; i < kernel::kHessianSize; ++i) {
    EXPECT_NEAR(once.sums.hessian[i], cpu.hessian[i],
                tolerance * (cpu.hessian[0] + cpu.hessian[6]));
    EXPECT_EQ(once.sums.hessian[i], again.sums.hessian[i]) << "differs from run to run";
  }
}

TYPED_TEST(ProbeOf, NoPixelsSumToNothing) {
  const Image<float> image = Waves();
  const ProbeResult<TypeParam> result = Probe<TypeParam>({image, kCamera, kPose, {}});
  EXPECT_TRUE(result.residuals.empty());
  EXPECT_EQ(result.sums.cost.count, 0);
}

TEST(Probe, WithoutADeviceIsAnError) {
  if (!DeviceList().empty()) GTEST_SKIP() << "there is a CUDA device";
  const Image<float> image = Waves();
  EXPECT_THROW(Probe<float>({image, kCamera, kPose, Pixels<float>()}), Error);
}

}  // namespace
}  // namespace silt::cuda
