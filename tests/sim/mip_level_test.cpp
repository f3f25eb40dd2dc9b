// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/mip_level.h"

#include <gtest/gtest.h>

#include <cmath>

#include "silt/core/color.h"

namespace silt::sim {
namespace {

Image<Rgba8> Ramp(int width, int height) {
  Image<Rgba8> picture(width, height);
  for (int i = 0; i < width * height; ++i) {
    picture.data()[i] = {std::uint8_t(7 * i), std::uint8_t(255 - 3 * i), std::uint8_t(i), 255};
  }
  return picture;
}

Float4 Value(const MipLevel& level, float x, float y) {
  MipLevel::Place place;
  level.Find(x, y, place);
  return place.Bilinear();
}

TEST(MipLevel, EncodingGivesThePictureBack) {
  Image<Rgba8> picture(16, 16);
  for (int i = 0; i < 256; ++i) {
    picture.data()[i] = {std::uint8_t(i), std::uint8_t(255 - i), std::uint8_t(i ^ 85),
                         std::uint8_t(i)};
  }
  EXPECT_EQ(MipLevel(picture).Encoded(), picture);
}

TEST(MipLevel, DigestsTellPicturesApart) {
  Image<Rgba8> picture = Ramp(5, 3);
  const std::string digest = MipLevel(picture).Digest();
  EXPECT_EQ(MipLevel(Ramp(5, 3)).Digest(), digest);
  EXPECT_NE(MipLevel(Image<Rgba8>(3, 5)).Digest(), MipLevel(Image<Rgba8>(5, 3)).Digest());
  picture(4, 2).b ^= 1;
  EXPECT_NE(MipLevel(picture).Digest(), digest);
}

// The nearest byte, in the encoding, also of values that no byte stands for.
TEST(MipLevel, MeansAreEncodedByTheNearestByte) {
  for (int a = 0; a < 256; a += 5) {
    for (int b = a; b < 256; b += 17) {
      Image<Rgba8> picture(2, 1);
      picture(0, 0).r = std::uint8_t(a);
      picture(1, 0).r = std::uint8_t(b);
      const float mean = (LinearFromSrgb(float(a) / 255) + LinearFromSrgb(float(b) / 255)) / 2;
      const int code = MipLevel(picture).Halved().Encoded()(0, 0).r;
      EXPECT_NEAR(code, 255 * SrgbFromLinear(mean), 0.53) << a << " " << b;
    }
  }
}

TEST(MipLevel, ValuesLieAtTheCentresOfTexels) {
  const Image<Rgba8> picture = Ramp(5, 3);
  const MipLevel level(picture);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const Float4 value = Value(level, float(x), float(y));
      EXPECT_EQ(value[0], float(level.at(x, y).r));
      EXPECT_EQ(value[2], float(level.at(x, y).b));
      EXPECT_EQ(value[3], 65535);
    }
  }
}

TEST(MipLevel, TheLastColumnAndRowMeetTheFirst) {
  const MipLevel level(Ramp(5, 3));
  const auto mean = [](const MipLevel::Texel& a, const MipLevel::Texel& b) {
    return (float(a.g) + float(b.g)) / 2;
  };
  EXPECT_NEAR(Value(level, 4.5f, 1)[1], mean(level.at(4, 1), level.at(0, 1)), 0.1);
  EXPECT_NEAR(Value(level, -0.5f, 1)[1], mean(level.at(4, 1), level.at(0, 1)), 0.1);
  EXPECT_NEAR(Value(level, 2, 2.5f)[1], mean(level.at(2, 2), level.at(2, 0)), 0.1);
  EXPECT_NEAR(Value(level, 2, -0.5f)[1], mean(level.at(2, 2), level.at(2, 0)), 0.1);
  // So little before the first texel that the sum with the width is rounded to it.
  EXPECT_NEAR(Value(level, -1e-9f, 1)[1], float(level.at(0, 1).g), 0.1);
}

// The short way for opaque pairs of rows and columns against the one for any.
TEST(MipLevel, OpaqueTexelsAreAveragedLikeAllOthers) {
  Image<Rgba8> picture = Ramp(8, 4);
  const MipLevel opaque = MipLevel(picture).Halved();
  for (Rgba8& texel : picture) texel.a = 254;
  const MipLevel nearly = MipLevel(picture).Halved();
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) {
      EXPECT_NEAR(opaque.at(x, y).r, nearly.at(x, y).r, 1);
      EXPECT_NEAR(opaque.at(x, y).g, nearly.at(x, y).g, 1);
    }
  }
}

}  // namespace
}  // namespace silt::sim
