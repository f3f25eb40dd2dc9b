// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

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

// Each has a buffer of its own until it is taken, in whatever order, and gives it back.
TEST(DeviceMemory, StartedCopiesComeBackWhenTheyAreTaken) {
  if (!WhyNoUsableDevice().empty()) GTEST_SKIP() << "no CUDA device";
  Stream stream;
  const void* last = nullptr;
  for (int round = 0; round < 2; ++round) {
    std::vector<std::unique_ptr<PinnedBuffer>> coming;
    for (int i = 0; i < 5; ++i) {
      const std::vector<int> values(100, 7 * i + round);
      void* const memory = stream.Allocate(400);
      stream.CopyToDevice(memory, values.data(), 400);
      coming.push_back(stream.StartCopyToHost(memory, 400));
      stream.Free(memory);
    }
    for (int i = 4; i >= 0; --i) {
      auto& buffer = coming[std::size_t(i)];
      const int* const taken = static_cast<const int*>(buffer->Take(400));
      EXPECT_EQ(std::vector<int>(taken, taken + 100), std::vector<int>(100, 7 * i + round));
      EXPECT_TRUE(round == 0 || i > 0 || taken == last);
      if (i == 0) last = taken;
      stream.TakeBack(std::move(buffer));
    }
  }
}

TEST(DeviceMemory, AStreamWithoutADeviceIsAnError) {
  if (!DeviceList().empty()) GTEST_SKIP() << "there is a CUDA device";
  EXPECT_EQ(ErrorOf([] { const Stream stream; }).rfind("CUDA: ", 0), 0u);
  EXPECT_EQ(ErrorOf([] { const EventTimer timer; }).rfind("CUDA: ", 0), 0u);
  EXPECT_EQ(ErrorOf([] { const DeviceArray<int> array(3); }).rfind("CUDA: ", 0), 0u);
}

}  // namespace
}  // namespace silt::cuda
