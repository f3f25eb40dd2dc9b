// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "silt/core/color.h"

namespace silt::sim {
namespace {

constexpr float kStep = 1.0f / 65535;  // of a stored texel

constexpr Rgba8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255}, kRed{255, 0, 0, 255};

Image<Rgba8> Checkerboard(int width, int height) {
  Image<Rgba8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture(x, y) = (x + y) % 2 ? kWhite : kBlack;
  }
  return picture;
}

TEST(TextureTest, TexelCentresReadTheLinearColour) {
  Image<Rgba8> picture(2, 2, kBlack);
  picture(0, 0) = {100, 150, 200, 255};  // upper left
  picture(1, 1) = kWhite;
  const Texture texture(picture);
  const Vec3f upper_left = texture.Sample(0.25f, 0.75f, 0);
  EXPECT_NEAR(upper_left.x, LinearFromSrgb(100 / 255.0f), kStep);
  EXPECT_NEAR(upper_left.y, LinearFromSrgb(150 / 255.0f), kStep);
  EXPECT_NEAR(upper_left.z, LinearFromSrgb(200 / 255.0f), kStep);
  EXPECT_NEAR(texture.Sample(0.75f, 0.25f, 0).x, 1, 1e-6);
  EXPECT_NEAR(texture.Sample(0.25f, 0.25f, 0).x, 0, 1e-6);
}

TEST(TextureTest, InterpolatesLinearLightNotItsEncoding) {
  Image<Rgba8> picture(4, 1, kBlack);
  picture(1, 0) = picture(2, 0) = kWhite;
  const Texture texture(picture);
  EXPECT_NEAR(texture.Sample(0.25f, 0.5f, 0).x, 0.5f, 1e-6);
  EXPECT_NEAR(texture.Sample(0.3125f, 0.5f, 0).x, 0.75f, 1e-6);
}

TEST(TextureTest, RepeatsInBothDirections) {
  Image<Rgba8> picture(4, 4);
  for (int i = 0; i < 16; ++i) {
    picture.data()[i] = {std::uint8_t(16 * i), std::uint8_t(255 - i), 7, 255};
  }
  const Texture texture(picture);
  for (const float u : {0.05f, 0.4f, 0.99f}) {
    for (const float v : {0.02f, 0.63f}) {
      const Vec3f inside = texture.Sample(u, v, 0.5f);
      const Vec3f outside = texture.Sample(u - 3, v + 2, 0.5f);
      EXPECT_NEAR(inside.x, outside.x, 1e-4);
      EXPECT_NEAR(inside.y, outside.y, 1e-4);
    }
  }
  // Over the seam the last column meets the first one.
  EXPECT_NEAR(
      texture.Sample(0, 0.125f, 0).x,
      0.5f * (LinearFromSrgb(picture(0, 3).r / 255.0f) + LinearFromSrgb(picture(3, 3).r / 255.0f)),
      kStep);
}

TEST(TextureTest, LevelsAverageLinearLight) {
  const Texture texture(Checkerboard(8, 4));
  EXPECT_EQ(texture.level_count(), 4);
  for (const float lod : {1.0f, 2.0f, 3.0f, 50.0f}) {
    EXPECT_NEAR(texture.Sample(0.3f, 0.6f, lod).x, 0.5f, kStep) << lod;
  }
}

TEST(TextureTest, LevelsOfOneColourKeepIt) {
  for (int i = 0; i < 256; ++i) {
    const auto byte = std::uint8_t(i);
    const Texture texture(Image<Rgba8>(4, 4, Rgba8{byte, byte, 0, 255}));
    EXPECT_EQ(texture.level(2)(0, 0), (Rgba8{byte, byte, 0, 255}));
  }
}

TEST(TextureTest, BlendsBetweenLevels) {
  const Texture texture(Checkerboard(4, 4));
  const float fine = texture.Sample(0.125f, 0.125f, 0).y;  // lower left texel: white
  const float coarse = texture.Sample(0.125f, 0.125f, 1).y;
  ASSERT_NEAR(fine, 1, 1e-6);
  EXPECT_NEAR(texture.Sample(0.125f, 0.125f, 0.25f).y, 0.75f * fine + 0.25f * coarse, kStep);
}

TEST(TextureTest, OddSizesKeepTheMean) {
  Image<Rgba8> picture(3, 5, kBlack);
  for (int y = 0; y < 5; ++y) picture(1, y) = kWhite;
  const Texture texture(picture);
  EXPECT_EQ(texture.level(1).width(), 1);
  EXPECT_EQ(texture.level(1).height(), 2);
  EXPECT_NEAR(texture.Sample(0.5f, 0.5f, 9).x, 1 / 3.0f, kStep);
}

TEST(TextureTest, OddSizesShareTheTexelInTheMiddle) {
  Image<Rgba8> picture(5, 5, kBlack);
  for (int i = 0; i < 5; ++i) picture(2, i) = kWhite;
  const Texture texture(picture);
  ASSERT_EQ(texture.level(1).width(), 2);
  // Half of one column in two and a half.
  const auto fifth = std::uint8_t(std::lround(255 * SrgbFromLinear(0.2f)));
  EXPECT_EQ(texture.level(1)(0, 0).r, fifth);
  EXPECT_EQ(texture.level(1)(1, 1).r, fifth);
}

TEST(TextureTest, ColourDoesNotFadeIntoInvisibleTexels) {
  Image<Rgba8> picture(4, 4, Rgba8{0, 255, 0, 0});
  picture(0, 0) = picture(1, 1) = kRed;
  const Texture texture(picture);
  for (const float lod : {0.0f, 1.0f, 2.0f}) {
    const Vec3f colour = texture.Sample(0.2f, 0.7f, lod);
    EXPECT_NEAR(colour.x, 1, 1e-6) << lod;
    EXPECT_NEAR(colour.y, 0, 1e-6) << lod;
  }
  EXPECT_EQ(texture.level(1)(0, 0).a, 128);
}

TEST(TextureTest, AlphaIsBilinear) {
  Image<Rgba8> picture(2, 1, kWhite);
  picture(1, 0).a = 0;
  const Texture texture(picture);
  EXPECT_NEAR(texture.Alpha(0.25f, 0.5f), 1, 1e-6);
  EXPECT_NEAR(texture.Alpha(0.75f, 0.5f), 0, 1e-6);
  EXPECT_NEAR(texture.Alpha(0.625f, 0.5f), 0.25f, 1e-6);
}

TEST(TextureTest, NonFiniteCoordinatesStayInside) {
  const Texture texture(Checkerboard(4, 4));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinity, -infinity, 1e30f, -1e-30f}) {
    const Vec3f colour = texture.Sample(bad, bad, bad);
    EXPECT_TRUE(colour.x >= 0 && colour.x <= 1) << bad;
    EXPECT_TRUE(std::isfinite(texture.Alpha(bad, bad))) << bad;
  }
}

}  // namespace
}  // namespace silt::sim
