// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/devices.h"

#include <gtest/gtest.h>

namespace silt::cuda {
namespace {

// Answers on every machine; describes what is there.
TEST(DeviceList, DescribesEachDevice) {
  for (const Device& device : DeviceList()) {
    EXPECT_FALSE(device.name.empty());
    EXPECT_GE(device.major, 5);
    EXPECT_GT(device.memory_bytes, std::size_t(1) << 28);
  }
}

TEST(DeviceList, GivesTheSameAnswerTwice) { EXPECT_EQ(DeviceList().size(), DeviceList().size()); }

TEST(DriverAndToolkit, AreVersionNumbers) {
  const Versions versions = DriverAndToolkit();
  EXPECT_GE(std::stod(versions.toolkit), 12.0);
  EXPECT_TRUE(versions.driver == "none" || std::stod(versions.driver) > 8);
  if (!DeviceList().empty()) {
    EXPECT_NE(versions.driver, "none");
  }
}

}  // namespace
}  // namespace silt::cuda
