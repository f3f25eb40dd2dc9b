// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/khoshelham_depth.h"

#include <gtest/gtest.h>

#include "depth_scene.h"

namespace silt::sim {
namespace {

TEST(KhoshelhamDepth, SigmaGrowsWithTheSquareOfDepthAtTenDepths) {
  for (int i = 1; i <= 10; ++i) {
    const double z = 0.5 * i, sigma = 0.001425 * z * z;
    const Image<float> measured = Measured({"khoshelham", {}}, Wall(z));
    ExpectMeanAndVariance(Values([&](int x, int y) { return double(measured(x, y)); }), z,
                          sigma * sigma);
  }
}

TEST(KhoshelhamDepth, NothingStaysNothing) {
  for (const float z : Measured({"khoshelham", {}}, Wall(0))) EXPECT_EQ(z, 0);
  // At 700 m the noise is as large as the depth.
  for (const float z : Measured({"khoshelham", {}}, Wall(700))) EXPECT_GE(z, 0);
}

}  // namespace
}  // namespace silt::sim
