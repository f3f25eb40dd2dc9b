// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/picture_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "sample_model.h"
#include "silt/core/error.h"
#include "silt/sim/picture.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

std::string Encoded(const std::string& extension, int width, int height) {
  std::vector<unsigned char> bytes;
  cv::imencode(extension, cv::Mat(height, width, CV_8UC3, cv::Scalar(1, 2, 3)), bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(PictureSize, IsReadFromTheHead) {
  for (const char* const extension : {".png", ".jpg", ".bmp", ".tiff"}) {
    const auto size = DeclaredPictureSize(Encoded(extension, 300, 17));
    ASSERT_TRUE(size.has_value()) << extension;
    EXPECT_EQ(size->width, 300u) << extension;
    EXPECT_EQ(size->height, 17u) << extension;
  }
}

// What encoders of today do not write: OS/2's bitmaps, TIFF with its high bytes first, fillers and
// stray bytes between JPEG's segments.
TEST(PictureSize, IsReadFromOtherHeads) {
  const auto expect = [](const std::string& file, std::uint64_t width, std::uint64_t height) {
    const auto size = DeclaredPictureSize(file);
    ASSERT_TRUE(size.has_value());
    EXPECT_EQ(size->width, width);
    EXPECT_EQ(size->height, height);
  };
  std::string bmp = "BM" + std::string(24, '\0');
  bmp.replace(14, 8, std::string("\x0c\0\0\0\x2c\x01\x11\0", 8));
  expect(bmp, 300, 17);
  expect(std::string("MM\0*\0\0\0\x08\0\x02"
                     "\x01\0\0\x03\0\0\0\x01\x01\x2c\0\0"
                     "\x01\x01\0\x04\0\0\0\x01\0\0\0\x11",
                     34),
         300, 17);
  std::string jpeg = Encoded(".jpg", 300, 17);
  jpeg.insert(2, "ab\xff");
  expect(jpeg, 300, 17);
}

TEST(PictureSize, IsUnknownOfOtherAndBrokenFiles) {
  EXPECT_FALSE(DeclaredPictureSize("").has_value());
  EXPECT_FALSE(DeclaredPictureSize("hello").has_value());
  const std::string tiff = Encoded(".tiff", 300, 17);
  for (std::size_t length = 0; length < 60; ++length) {
    DeclaredPictureSize(tiff.substr(0, length));
  }
  const std::string jpeg = Encoded(".jpg", 300, 17);
  for (std::size_t length = 0; length < 150; ++length) {
    EXPECT_FALSE(DeclaredPictureSize(jpeg.substr(0, length)).has_value()) << length;
  }
  EXPECT_FALSE(DeclaredPictureSize(std::string("\xff\xd8\xff\xe0\0\0\0\0\0\0\0\0", 12)));
}

TEST(PictureSize, AHugePictureIsRefusedBeforeItIsDecoded) {
  EncodedPicture picture;
  picture.place = "bomb.png";
  std::string png = SamplePng();
  png.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));  // 30000 × 30000
  picture.colour = std::make_shared<const std::string>(png);
  EXPECT_THAT(ErrorOf([&] { DecodePicture(picture); }),
              testing::HasSubstr("bomb.png: has 30000 x 30000 pixels"));
}

}  // namespace
}  // namespace silt::sim
