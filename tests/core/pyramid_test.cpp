// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/pyramid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "silt/core/camera.h"
#include "silt/core/depth_jump.h"
#include "silt/core/random.h"

namespace silt {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image<float> Block(float a, float b, float c, float d) {
  Image<float> image(2, 2);
  image(0, 0) = a;
  image(1, 0) = b;
  image(0, 1) = c;
  image(1, 1) = d;
  return image;
}

float HalvedBlockDepth(float a, float b, float c, float d) {
  return HalvedDepth(Block(a, b, c, d))(0, 0);
}

TEST(PyramidTest, IntensityIsTheMeanOfItsOwnBlock) {
  Image<float> image(6, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) image(x, y) = float(x * x + 10 * y * y);
  }
  const Image<float> half = HalvedIntensity(image);
  ASSERT_EQ(half.width(), 3);
  ASSERT_EQ(half.height(), 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const int l = 2 * x, t = 2 * y;
      EXPECT_FLOAT_EQ(half(x, y), 0.5f * float(l * l + (l + 1) * (l + 1)) +
                                      5.0f * float(t * t + (t + 1) * (t + 1)));
    }
  }
}

TEST(PyramidTest, IntensityKeepsTheMeanOfTheImage) {
  Image<float> image(64, 48);
  const CounterRandom random(3);
  double sum = 0;
  for (std::size_t i = 0; i < image.size(); ++i) sum += image.data()[i] = float(random.Uniform(i));
  double half_sum = 0;
  for (float value : HalvedIntensity(image)) half_sum += value;
  EXPECT_NEAR(half_sum / (32 * 24), sum / (64 * 48), 1e-7);
}

TEST(PyramidTest, OddLastColumnAndRowDrop) {
  Image<float> image(5, 3, 1.0f);
  for (int y = 0; y < 3; ++y) image(4, y) = 100;
  for (int x = 0; x < 5; ++x) image(x, 2) = 100;
  const Image<float> intensity = HalvedIntensity(image), depth_m = HalvedDepth(image);
  EXPECT_EQ(intensity, Image<float>(2, 1, 1.0f));
  EXPECT_EQ(depth_m, Image<float>(2, 1, 1.0f));
}

TEST(PyramidTest, NothingIsLeftOfOnePixel) {
  EXPECT_TRUE(HalvedIntensity(Image<float>(1, 1)).empty());
  EXPECT_TRUE(HalvedDepth(Image<float>()).empty());
}

TEST(PyramidTest, DepthOfAnEdgeIsThatOfTheNearSide) {
  EXPECT_FLOAT_EQ(HalvedBlockDepth(1, 2, 2, 2), 1);
  EXPECT_FLOAT_EQ(HalvedBlockDepth(2, 1, 1, 2), 1);
  EXPECT_FLOAT_EQ(HalvedBlockDepth(2, 2, 2, 1.5f), 1.5f);
}

TEST(PyramidTest, DepthTakesTheMeanOfTheInverse) {
  EXPECT_FLOAT_EQ(HalvedBlockDepth(1.00f, 1.01f, 1.02f, 1.03f),
                  4 / (1 / 1.00f + 1 / 1.01f + 1 / 1.02f + 1 / 1.03f));
}

// A step that is left out beside as an edge is no surface to average over, and a smaller one is.
TEST(PyramidTest, DepthTakesForAnEdgeWhatIsADepthJump) {
  EXPECT_TRUE(IsDepthJump(1, 1.04f));
  EXPECT_FLOAT_EQ(HalvedBlockDepth(1.04f, 1, 1.04f, 1), 1);
  EXPECT_FALSE(IsDepthJump(1, 1.02f));
  EXPECT_FLOAT_EQ(HalvedBlockDepth(1.02f, 1, 1.02f, 1), 2 / (1 / 1.02f + 1));
}

TEST(PyramidTest, DepthPassesOverWhatIsNotMeasured) {
  EXPECT_FLOAT_EQ(HalvedBlockDepth(0, kNaN, kInfinity, 2), 2);
  EXPECT_FLOAT_EQ(HalvedBlockDepth(-1, 3, 3, 0), 3);
  EXPECT_EQ(HalvedBlockDepth(0, kNaN, -kInfinity, -2), 0);
}

// Whatever the block, the result lies between its nearest measurement and what is on its surface.
TEST(PyramidTest, DepthNeverMixesAnEdge) {
  Image<float> depth_m(128, 128);
  const CounterRandom random(5);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const double draw = random.Uniform(2 * i);
    const float surface_m = draw < 0.2 ? 0 : draw < 0.6 ? 1.0f : draw < 0.8 ? 1.2f : 4.0f;
    depth_m.data()[i] = surface_m * float(1 + 0.02 * random.Uniform(2 * i + 1));
  }
  const Image<float> half = HalvedDepth(depth_m);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      float nearest = kInfinity;
      for (int i = 0; i < 4; ++i) {
        const float z = depth_m(2 * x + i % 2, 2 * y + i / 2);
        if (z > 0) nearest = std::min(nearest, z);
      }
      if (nearest == kInfinity) {
        EXPECT_EQ(half(x, y), 0);
      } else {
        EXPECT_GE(half(x, y), nearest * (1 - 1e-6f));
        EXPECT_LE(half(x, y), nearest * 1.0201f);
      }
    }
  }
}

// Depth z of the plane n·p = 1 along the ray through a pixel.
double PlaneDepth(const PinholeCamera& camera, const Vec3d& n, double u, double v) {
  return 1 / Dot(n, camera.Unproject(u, v, 1.0));
}

TEST(PyramidTest, DepthOfAPlaneIsExactOnEveryLevel) {
  const Vec3d n{0.2, -0.1, 0.4};
  PinholeCamera camera = kIclNuimCamera;
  Image<float> depth_m(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) depth_m(x, y) = float(PlaneDepth(camera, n, x, y));
  }
  for (int level = 1; level <= 3; ++level) {
    camera = camera.Halved();
    depth_m = HalvedDepth(depth_m);
    double largest = 0;
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const double z = PlaneDepth(camera, n, x, y);
        largest = std::max(largest, std::abs(depth_m(x, y) - z) / z);
      }
    }
    EXPECT_LT(largest, 5e-7) << "level " << level;
  }
}

TEST(PyramidTest, MeasuredMeansFiniteAndPositive) {
  EXPECT_TRUE(IsMeasured(0.001f));
  EXPECT_TRUE(IsMeasured(1000));
  for (float z : {0.0f, -0.0f, -1.0f, kNaN, kInfinity, -kInfinity}) EXPECT_FALSE(IsMeasured(z));
}

}  // namespace
}  // namespace silt
