// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/cuda/device_needs.h"

#include <gtest/gtest.h>

namespace silt::cuda {
namespace {

TEST(OutOfMemoryText, TellsHowMuchAndWhatToDo) {
  EXPECT_EQ(OutOfMemoryText(std::size_t(3) << 20),
            "CUDA: the device has no 3 MiB left; use smaller images, fewer keyframes or fewer "
            "starts at once");
  EXPECT_NE(OutOfMemoryText(1).find("no 1 MiB left"), std::string::npos);
  EXPECT_NE(OutOfMemoryText((std::size_t(1) << 20) + 1).find("no 2 MiB left"), std::string::npos);
}

}  // namespace
}  // namespace silt::cuda
