// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "silt/core/error.h"
#include "silt/cuda/device_array.cuh"
#include "silt/cuda/devices.h"
#include "silt/cuda/stream.cuh"

namespace silt::cuda {
namespace {

constexpr std::size_t kTooMuch = std::size_t(1) << 42;

template <typename Allocate>
std::string ErrorOf(const Allocate& allocate) {
  try {
    allocate();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// And goes on serving.
TEST(DeviceMemory, WhatTheDeviceDoesNotHaveIsOneClearLine) {
  if (!WhyNoUsableDevice().empty()) GTEST_SKIP() << "no CUDA device";
  const Stream stream;
  EXPECT_EQ(ErrorOf([&] { stream.Allocate(kTooMuch); }), OutOfMemoryText(kTooMuch));
  EXPECT_EQ(ErrorOf([] { DeviceArray<char> array(kTooMuch); }), OutOfMemoryText(kTooMuch));
  void* const memory = stream.Allocate(1 << 20);
  EXPECT_NE(memory, nullptr);
  stream.Free(memory);
}

TEST(DeviceMemory, AStreamWithoutADeviceIsAnError) {
  if (!DeviceList().empty()) GTEST_SKIP() << "there is a CUDA device";
  EXPECT_EQ(ErrorOf([] { const Stream stream; }).rfind("CUDA: ", 0), 0u);
  EXPECT_EQ(ErrorOf([] { const EventTimer timer; }).rfind("CUDA: ", 0), 0u);
  EXPECT_EQ(ErrorOf([] { const DeviceArray<int> array(3); }).rfind("CUDA: ", 0), 0u);
}

}  // namespace
}  // namespace silt::cuda
