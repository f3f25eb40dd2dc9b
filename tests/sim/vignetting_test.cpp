// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/vignetting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{30, 32, 21.5, 14.25, 40, 30};

TEST(Vignetting, FallsOffWithTheFourthPowerOfTheCosine) {
  const Image<float> shares = VignettingShares({.cos4 = true}, kCamera, nullptr);
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const double theta = std::atan(std::hypot((x - 21.5) / 30, (y - 14.25) / 32));
      EXPECT_NEAR(shares(x, y), std::pow(std::cos(theta), 4), 1e-6);
    }
  }
}

TEST(Vignetting, ThePolynomialCountsInHalfDiagonals) {
  const Image<float> shares = VignettingShares({false, -0.3, 0.05, -0.1}, kCamera, nullptr);
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const double r = std::hypot(x - 21.5, y - 14.25) / 25;
      EXPECT_NEAR(shares(x, y), 1 - 0.3 * r * r + 0.05 * std::pow(r, 4) - 0.1 * std::pow(r, 6),
                  1e-6);
    }
  }
}

TEST(Vignetting, BothMultiply) {
  const Image<float> natural = VignettingShares({.cos4 = true}, kCamera, nullptr);
  const Image<float> polynomial = VignettingShares({false, -0.3, 0, 0}, kCamera, nullptr);
  const Image<float> both = VignettingShares({true, -0.3, 0, 0}, kCamera, nullptr);
  EXPECT_NEAR(both(3, 27), natural(3, 27) * polynomial(3, 27), 1e-6);
  EXPECT_LT(both(3, 27), natural(3, 27));
}

// θ is that of the ray, which a lens bends.
TEST(Vignetting, TheCosineIsThatOfTheRayThroughTheLens) {
  const LensDistortion lens{-0.2, 0.05, 0, 0, 0};
  const LensMap map(kCamera, lens);
  const Image<float> shares = VignettingShares({.cos4 = true}, kCamera, &map);
  const Vec2d ray = lens.Undistort(Vec2d{(2 - 21.5) / 30, (3 - 14.25) / 32});
  const double theta = std::atan(std::hypot(ray.x, ray.y));
  EXPECT_NEAR(shares(2, 3), std::pow(std::cos(theta), 4), 1e-6);
  EXPECT_LT(shares(2, 3), VignettingShares({.cos4 = true}, kCamera, nullptr)(2, 3) - 0.005);
}

TEST(Vignetting, RefusesALensThatGivesOrTakesLight) {
  EXPECT_THROW(VignettingShares({false, -1.1, 0, 0}, kCamera, nullptr), Error);
  EXPECT_THROW(VignettingShares({false, 0.1, 0, 0}, kCamera, nullptr), Error);
  EXPECT_THROW(VignettingShares({false, std::nan(""), 0, 0}, kCamera, nullptr), Error);
  EXPECT_TRUE(Vignetting{}.IsNone());
  EXPECT_FALSE((Vignetting{false, 0, 0, 0.1}).IsNone());
}

}  // namespace
}  // namespace silt::sim
