// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "sample_model.h"
#include "silt/sim/picture_set.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

Bytes Share(const std::string& bytes) { return std::make_shared<const std::string>(bytes); }

Bytes Encode(const cv::Mat& image, const char* extension = ".png") {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, image, bytes);
  return Share({bytes.begin(), bytes.end()});
}

EncodedPicture Picture(const std::string& place, Bytes colour) {
  EncodedPicture picture;
  picture.place = place;
  picture.colour = std::move(colour);
  return picture;
}

TEST(PictureTest, DecodesColourAndAlpha) {
  const Image<Rgba8> decoded = DecodePicture(Picture("p", Share(SamplePng(true))));
  ASSERT_EQ(decoded.width(), 2);
  EXPECT_EQ(decoded(0, 0), (Rgba8{255, 0, 0, 255}));
  EXPECT_EQ(decoded(1, 0), (Rgba8{0, 255, 0, 255}));
  EXPECT_EQ(decoded(0, 1), (Rgba8{0, 0, 255, 255}));
  EXPECT_EQ(decoded(1, 1), (Rgba8{255, 255, 255, 0}));
}

TEST(PictureTest, DecodesGrayAnd16Bits) {
  const cv::Mat gray(1, 1, CV_8UC1, cv::Scalar(77));
  EXPECT_EQ(DecodePicture(Picture("p", Encode(gray)))(0, 0), (Rgba8{77, 77, 77, 255}));
  const cv::Mat deep(1, 1, CV_16UC3, cv::Scalar(65535, 257 * 3, 257 * 200));
  EXPECT_EQ(DecodePicture(Picture("p", Encode(deep)))(0, 0), (Rgba8{200, 3, 255, 255}));
  const cv::Mat colour(8, 8, CV_8UC3, cv::Scalar(0, 0, 250));
  EXPECT_NEAR(DecodePicture(Picture("p", Encode(colour, ".jpg")))(3, 3).r, 250, 4);
}

TEST(PictureTest, TakesOpacityFromASecondPicture) {
  EncodedPicture picture = Picture("p", Share(SamplePng()));
  cv::Mat mask(2, 2, CV_8UC1, cv::Scalar(255));
  mask.at<std::uint8_t>(0, 1) = 10;
  picture.opacity = Encode(mask);
  EXPECT_EQ(DecodePicture(picture)(1, 0), (Rgba8{0, 255, 0, 10}));
  EXPECT_EQ(DecodePicture(picture)(0, 0).a, 255);
  picture.opacity = Share(SamplePng(true));  // its alpha, not its brightness
  EXPECT_EQ(DecodePicture(picture)(1, 1).a, 0);
  EXPECT_EQ(DecodePicture(picture)(0, 1).a, 255);
  picture.opacity = Encode(cv::Mat(7, 5, CV_8UC1, cv::Scalar(99)));  // of another size
  EXPECT_EQ(DecodePicture(picture)(1, 1).a, 99);
}

TEST(PictureTest, RefusesWhatIsNoPicture) {
  for (const std::string& bytes :
       {std::string(), std::string("hello"), SamplePng().substr(0, 40)}) {
    const std::string message = ErrorOf([&] { DecodePicture(Picture("a/b.png", Share(bytes))); });
    EXPECT_THAT(message, HasSubstr("a/b.png: is not an image, or is damaged"));
  }
}

TEST(PictureSetTest, KeepsEachPictureOnce) {
  PictureSet set;
  const Bytes png = Share(SamplePng(true));
  EXPECT_EQ(set.Add(Picture("a", png), ""), 0);
  EXPECT_EQ(set.Add(Picture("b", Share(SamplePng())), ""), 1);
  EXPECT_EQ(set.Add(Picture("a", png), ""), 0);
  EncodedPicture with_opacity = Picture("a", png);
  with_opacity.opacity_place = "b";
  EXPECT_EQ(set.Add(with_opacity, ""), 2);
  const std::vector<PictureSet::Decoded> decoded = std::move(set).Decode();
  ASSERT_EQ(decoded.size(), 3u);
  EXPECT_TRUE(decoded[0].has_holes);
  EXPECT_FALSE(decoded[1].has_holes);
  EXPECT_EQ(decoded[1].texture->width(), 2);
}

TEST(PictureSetTest, DamageIsAnErrorOnlyAtAPlace) {
  PictureSet tolerant;
  tolerant.Add(Picture("a.png", Share("bad")), "");
  const std::vector<PictureSet::Decoded> decoded = std::move(tolerant).Decode();
  EXPECT_FALSE(decoded.at(0).texture.has_value());
  EXPECT_THAT(decoded[0].problem, HasSubstr("a.png: is not an image"));
  PictureSet strict;
  strict.Add(Picture("a.png", Share("bad")), "");
  strict.Add(Picture("a.png", Share("bad")), "scene.toml:4");
  EXPECT_THAT(ErrorOf([&] { std::move(strict).Decode(); }),
              HasSubstr("scene.toml:4: a.png: is not an image"));
}

}  // namespace
}  // namespace silt::sim
