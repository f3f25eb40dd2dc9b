// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/cuda_backend.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/cuda/devices.h"

namespace silt::cuda {
namespace {

TEST(CudaBackend, WithoutADeviceIsOneClearLine) {
  if (WhyNoUsableDevice().empty()) GTEST_SKIP() << "there is a CUDA device";
  try {
    MakeCudaBackend();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), "--backend cuda: " + WhyNoUsableDevice() + "; use --backend cpu");
  }
}

}  // namespace
}  // namespace silt::cuda
