// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/accuracy_output.h"
#include "silt/experiments/base64.h"
#include "silt/experiments/progress.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

TEST(Json, IsWrittenInOrderAndReadBack) {
  const TestFolder folder;
  const Json json{{"z", 1}, {"a", {1.5, nullptr}}};
  WriteJson(folder / "x/y.json", json);
  EXPECT_EQ(ReadJson(folder / "x/y.json"), json);
  EXPECT_LT(ReadText(folder / "x/y.json").find("\"z\""),
            ReadText(folder / "x/y.json").find("\"a\""));
}

TEST(Json, ThatIsNoneIsRefusedWithTheFilesName) {
  const TestFolder folder;
  std::ofstream(folder / "bad.json") << "{\"a\": ";
  for (const auto& file : {folder / "bad.json", folder / "none.json", folder.path()}) {
    try {
      ReadJson(file);
      FAIL() << file;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(file.string()));
    }
  }
}

// The examples of RFC 4648, section 10.
TEST(Base64, OfTheStandardsExamples) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64("\xff\xfe\xfd"), "//79");
}

TEST(Duration, IsReadable) {
  EXPECT_EQ(FormatDuration(7.4), "0:07");
  EXPECT_EQ(FormatDuration(750), "12:30");
  EXPECT_EQ(FormatDuration(3723), "1:02:03");
  EXPECT_EQ(FormatDuration(-1), "0:00");
}

TEST(DepthPicture, IsBrightWhereNearAndBlackWhereNothingIsMeasured) {
  Image<float> depth_m(4, 1);
  depth_m(0, 0) = 1;
  depth_m(1, 0) = 2;
  depth_m(2, 0) = 4;
  depth_m(3, 0) = std::nanf("");
  const Image<Rgb8> picture = DepthPicture(depth_m);
  EXPECT_EQ(picture(0, 0), (Rgb8{255, 255, 255}));
  // 1/z = ½ lies a third of the way from ¼ to 1: 20 + 235/3.
  EXPECT_EQ(picture(1, 0), (Rgb8{98, 98, 98}));
  EXPECT_EQ(picture(2, 0), (Rgb8{20, 20, 20}));
  EXPECT_EQ(picture(3, 0), Rgb8{});
}

}  // namespace
}  // namespace silt::experiments
