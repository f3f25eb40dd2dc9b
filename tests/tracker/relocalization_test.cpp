// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/tracker/relocalization.h"

#include <gmock/gmock.h>

#include "analytic_room.h"

namespace silt::tracker {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Image<float> ThumbnailAt(double turn_rad, float brightness = 1, float offset = 0) {
  Image<float> view = RenderRoom({Quaterniond::Exp({0, turn_rad, 0}), {}}).intensity;
  for (float& value : view) value = brightness * value + offset;
  return Thumbnail(view);
}

TEST(Relocalization, AThumbnailIsSmallAndKnowsNoBrightness) {
  const Image<float> thumbnail = ThumbnailAt(0.3), paler = ThumbnailAt(0.3, 0.5f, 0.2f);
  EXPECT_EQ(thumbnail.width(), 16);
  EXPECT_EQ(thumbnail.height(), 12);
  double squares = 0;
  for (std::size_t i = 0; i < thumbnail.size(); ++i) {
    EXPECT_NEAR(thumbnail.data()[i], paler.data()[i], 1e-5);
    squares += double(thumbnail.data()[i]) * double(thumbnail.data()[i]);
  }
  EXPECT_NEAR(squares, 1, 1e-5);
}

TEST(Relocalization, AnEvenImageIsLikeNothing) {
  EXPECT_EQ(Thumbnail(Image<float>(160, 120, 0.4f)), Image<float>(16, 12));
}

TEST(Relocalization, WhatLooksTheSameWayComesFirst) {
  std::vector<Image<float>> thumbnails;
  for (const double turn : {0.0, 1.0, 2.0, 3.0, 4.0}) thumbnails.push_back(ThumbnailAt(turn));
  std::vector<const Image<float>*> all;
  for (const auto& thumbnail : thumbnails) all.push_back(&thumbnail);
  EXPECT_EQ(MostAlike(all, ThumbnailAt(2.1, 0.7f), 1), std::vector<int>{2});
  EXPECT_EQ(MostAlike(all, ThumbnailAt(3.95), 3).front(), 4);
  EXPECT_EQ(MostAlike(all, ThumbnailAt(1), 9).size(), 5u);
}

TEST(Relocalization, EquallyAlikeOnesComeInTheirOrder) {
  const Image<float> one = ThumbnailAt(0);
  EXPECT_THAT(MostAlike({&one, &one, &one}, one, 2), ElementsAre(0, 1));
  EXPECT_THAT(MostAlike({&one}, one, 0), IsEmpty());
  EXPECT_THAT(MostAlike({}, one, 3), IsEmpty());
}

}  // namespace
}  // namespace silt::tracker
