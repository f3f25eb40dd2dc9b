// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/image.h"

#include <gtest/gtest.h>

namespace silt {
namespace {

TEST(ImageTest, StartsFilledAndEmptyByDefault) {
  EXPECT_TRUE(Image<float>().empty());
  const Image<int> image(3, 2, 7);
  EXPECT_EQ(image.width(), 3);
  EXPECT_EQ(image.height(), 2);
  ASSERT_EQ(image.size(), 6u);
  for (int value : image) EXPECT_EQ(value, 7);
  EXPECT_EQ(Image<float>(2, 2)(1, 1), 0);
}

TEST(ImageTest, LiesRowByRowWithoutPadding) {
  Image<int> image(5, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) image(x, y) = 10 * y + x;
  }
  for (int i = 0; i < 15; ++i) EXPECT_EQ(image.data()[i], 10 * (i / 5) + i % 5);
  EXPECT_EQ(image.row(2)[4], 24);
  EXPECT_EQ(image.row(1), image.data() + 5);
}

TEST(ImageTest, StartsOnACacheLine) {
  for (int width : {1, 3, 17, 640}) {
    const Image<std::uint8_t> bytes(width, 3);
    const Image<Rgb8> colours(width, 3);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.data()) % kImageAlignment, 0u);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(colours.data()) % kImageAlignment, 0u);
  }
}

TEST(ImageTest, ContainsItsPixelsAndNoOthers) {
  const Image<int> image(4, 3);
  EXPECT_TRUE(image.Contains(0, 0));
  EXPECT_TRUE(image.Contains(3, 2));
  EXPECT_FALSE(image.Contains(4, 2));
  EXPECT_FALSE(image.Contains(3, 3));
  EXPECT_FALSE(image.Contains(-1, 0));
  EXPECT_FALSE(image.Contains(0, -1));
}

TEST(ImageTest, EqualityIsOfSizeAndValues) {
  Image<int> a(2, 3, 1), b(3, 2, 1), c(2, 3, 1);
  EXPECT_NE(a, b);
  EXPECT_EQ(a, c);
  c(1, 2) = 2;
  EXPECT_NE(a, c);
}

TEST(ImageTest, NegativeSizeBreaksTheContract) {
  for (auto [width, height] : {std::pair{-1, 5}, {5, -1}, {-1, -1}, {-2, 0}}) {
    try {
      Image<float> image(width, height);
      ADD_FAILURE() << width << " x " << height;
    } catch (const std::logic_error& e) {
      EXPECT_EQ(std::string(e.what()).rfind("contract broken: ", 0), 0u) << e.what();
    }
  }
}

}  // namespace
}  // namespace silt
