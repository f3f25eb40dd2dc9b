// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/cuda_backend.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"
#include "silt/cuda/devices.h"

namespace silt::cuda {
namespace {

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
