// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/device_needs.h"

#include <gtest/gtest.h>

#include "silt/core/error.h"

namespace silt::cuda {
namespace {

constexpr int kToolkit = 13000;

Device Good() { return {"A GPU", 7, 5, std::size_t(8) << 30, true, true}; }

TEST(WhyNoDevice, TellsAnOldDriverFromNone) {
  EXPECT_EQ(WhyNoDevice(0, kToolkit), "no CUDA device is at hand");
  EXPECT_EQ(WhyNoDevice(13010, kToolkit), "no CUDA device is at hand");
  EXPECT_EQ(WhyNoDevice(13000, 13010), "no CUDA device is at hand");
  EXPECT_EQ(WhyNoDevice(11040, kToolkit),
            "the driver is too old: it knows CUDA 11.4, and this program was compiled with 13.0");
}

TEST(WhatLacks, NothingOfADeviceThatServes) {
  EXPECT_EQ(WhatLacks(Good()), "");
  Device newer = Good();
  newer.major = 9;
  newer.minor = 0;
  EXPECT_EQ(WhatLacks(newer), "");
}

TEST(WhatLacks, NamesIt) {
  Device device = Good();
  device.minor = 0;
  EXPECT_EQ(WhatLacks(device), "A GPU is of compute capability 7.0, and 7.5 is needed");
  device.major = 6;
  device.minor = 9;
  EXPECT_EQ(WhatLacks(device), "A GPU is of compute capability 6.9, and 7.5 is needed");
  device = Good();
  device.cooperative_launch = false;
  EXPECT_EQ(WhatLacks(device), "A GPU cannot launch cooperative kernels");
  device = Good();
  device.memory_pools = false;
  EXPECT_EQ(WhatLacks(device), "A GPU has no memory pools");
}

TEST(LimitedBlocks, AreNoMoreThanTheDeviceHolds) {
  EXPECT_EQ(LimitedBlocks(264, nullptr), 264);
  EXPECT_EQ(LimitedBlocks(264, "8"), 8);
  EXPECT_EQ(LimitedBlocks(4, "8"), 4);
  for (const char* text : {"", "0", "-3", "8x", "many"}) {
    EXPECT_THROW(LimitedBlocks(264, text), Error) << text;
  }
}

TEST(OutOfMemoryText, TellsHowMuchAndWhatToDo) {
  EXPECT_EQ(OutOfMemoryText(std::size_t(3) << 20),
            "CUDA: the device has no 3 MiB left; use smaller images, fewer keyframes or fewer "
            "starts at once");
  EXPECT_NE(OutOfMemoryText(1).find("no 1 MiB left"), std::string::npos);
  EXPECT_NE(OutOfMemoryText((std::size_t(1) << 20) + 1).find("no 2 MiB left"), std::string::npos);
}

}  // namespace
}  // namespace silt::cuda
