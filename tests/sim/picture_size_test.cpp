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
  for (const char* const extension : {".png", ".jpg", ".bmp"}) {
    const auto size = DeclaredPictureSize(Encoded(extension, 300, 17));
    ASSERT_TRUE(size.has_value()) << extension;
    EXPECT_EQ(size->width, 300u) << extension;
    EXPECT_EQ(size->height, 17u) << extension;
  }
}

TEST(PictureSize, IsUnknownOfOtherAndBrokenFiles) {
  EXPECT_FALSE(DeclaredPictureSize("").has_value());
  EXPECT_FALSE(DeclaredPictureSize("hello").has_value());
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
