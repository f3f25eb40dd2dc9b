// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ImageFileTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("image_file_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path Png(const std::string& name, const cv::Mat& image) const {
    EXPECT_TRUE(cv::imwrite((folder_ / name).string(), image));
    return folder_ / name;
  }
  fs::path Bytes(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  // The message of the error, which must be one line that names the file.
  static std::string ErrorOf(const fs::path& file, const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(file.string() + ": "));
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      return e.what();
    }
    return "no error";
  }

  fs::path folder_;
};

Image<Rgb8> Noise(int width, int height) {
  Image<Rgb8> rgb(width, height);
  const CounterRandom random(2);
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const std::uint64_t bits = random.Bits(i);
    rgb.data()[i] = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16)};
  }
  return rgb;
}

TEST_F(ImageFileTest, RgbRoundTripIsExact) {
  const Image<Rgb8> rgb = Noise(33, 17);
  WriteRgb(folder_ / "new" / "rgb.png", rgb);
  EXPECT_EQ(ReadRgb(folder_ / "new" / "rgb.png"), rgb);
}

TEST_F(ImageFileTest, RedIsRed) {
  const fs::path file = Png("red.png", cv::Mat(2, 2, CV_8UC3, cv::Scalar(0, 0, 255)));
  EXPECT_EQ(ReadRgb(file)(1, 1), (Rgb8{255, 0, 0}));
}

TEST_F(ImageFileTest, GrayAlphaAndSixteenBitsBecomeRgb) {
  const fs::path gray = Png("gray.png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(77)));
  EXPECT_EQ(ReadRgb(gray)(0, 0), (Rgb8{77, 77, 77}));
  const fs::path alpha = Png("alpha.png", cv::Mat(2, 2, CV_8UC4, cv::Scalar(1, 2, 3, 0)));
  EXPECT_EQ(ReadRgb(alpha)(0, 0), (Rgb8{3, 2, 1}));
  const fs::path wide = Png("wide.png", cv::Mat(2, 2, CV_16UC3, cv::Scalar(0, 0, 0x8000)));
  EXPECT_EQ(ReadRgb(wide)(0, 0), (Rgb8{128, 0, 0}));
  const fs::path deep = Png("deep.png", cv::Mat(2, 2, CV_16UC1, cv::Scalar(0x4dff)));
  EXPECT_EQ(ReadRgb(deep)(0, 0), (Rgb8{0x4d, 0x4d, 0x4d}));
}

TEST_F(ImageFileTest, DepthRoundTripIsRoundedToTheStep) {
  Image<float> depth_m(40, 30);
  const CounterRandom random(4);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    depth_m.data()[i] = float(0.001 + 13.1 * random.Uniform(i));
  }
  WriteDepth(folder_ / "depth.png", depth_m);
  const Image<float> back = ReadDepth(folder_ / "depth.png");
  ASSERT_EQ(back.width(), 40);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    EXPECT_NEAR(back.data()[i], depth_m.data()[i], 0.5 / kTumDepthPerMetre + 1e-6);
  }
}

TEST_F(ImageFileTest, DepthScaleIsStepsPerMetre) {
  const fs::path file = Png("depth.png", cv::Mat(1, 1, CV_16UC1, cv::Scalar(10000)));
  EXPECT_FLOAT_EQ(ReadDepth(file)(0, 0), 2);
  EXPECT_FLOAT_EQ(ReadDepth(file, 1000)(0, 0), 10);
}

TEST_F(ImageFileTest, DepthThatCannotBeSaidIsZero) {
  Image<float> depth_m(6, 1);
  const float value[] = {0,    -1,    std::numeric_limits<float>::quiet_NaN(),
                         1e9f, 13.2f, std::numeric_limits<float>::infinity()};
  std::copy(std::begin(value), std::end(value), depth_m.data());
  WriteDepth(folder_ / "depth.png", depth_m);
  EXPECT_EQ(ReadDepth(folder_ / "depth.png"), Image<float>(6, 1, 0.0f));
}

TEST_F(ImageFileTest, WrongKindOfDepthIsNamed) {
  const fs::path bytes = Png("bytes.png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(1)));
  EXPECT_THAT(ErrorOf(bytes, [&] { ReadDepth(bytes); }), HasSubstr("16-bit"));
  const fs::path color = Png("color.png", cv::Mat(2, 2, CV_16UC3, cv::Scalar(1)));
  EXPECT_THAT(ErrorOf(color, [&] { ReadDepth(color); }), HasSubstr("16-bit"));
}

TEST_F(ImageFileTest, UnreadableFilesAreNamed) {
  const fs::path missing = folder_ / "missing.png";
  EXPECT_THAT(ErrorOf(missing, [&] { ReadRgb(missing); }), HasSubstr("no such image"));
  EXPECT_THAT(ErrorOf(folder_, [&] { ReadRgb(folder_); }), HasSubstr("no such image"));
  for (const auto& file : {Bytes("empty.png", ""), Bytes("text.png", "not a picture\n")}) {
    EXPECT_THAT(ErrorOf(file, [&] { ReadRgb(file); }), HasSubstr("is not an image"));
    EXPECT_THAT(ErrorOf(file, [&] { ReadDepth(file); }), HasSubstr("is not an image"));
  }
}

// Cut anywhere, a PNG is refused: no half picture is taken for a whole one.
TEST_F(ImageFileTest, TruncatedPngIsRefused) {
  WriteRgb(folder_ / "whole.png", Noise(64, 64));
  std::ostringstream bytes;
  bytes << std::ifstream(folder_ / "whole.png", std::ios::binary).rdbuf();
  const std::string whole = bytes.str();
  for (double part : {0.01, 0.1, 0.5, 0.9}) {
    const fs::path file =
        Bytes("cut.png", whole.substr(0, std::size_t(part * double(whole.size()))));
    EXPECT_THAT(ErrorOf(file, [&] { ReadRgb(file); }), HasSubstr("damaged")) << part;
  }
}

TEST_F(ImageFileTest, FullDiskLeavesNoPicture) {
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  // 64 bytes hold less than the header; 3 KB less than what a C stream buffers before it writes.
  for (rlim_t bytes : {64, 3000, 8000}) {
    const rlimit limit{bytes, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = ErrorOf(folder_ / "rgb.png", [&] {
      WriteRgb(folder_ / "rgb.png", Noise(bytes == 64 ? 8 : 64, bytes == 64 ? 16 : 64));
    });
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(error, HasSubstr("File too large")) << bytes;
    EXPECT_TRUE(fs::is_empty(folder_)) << bytes;
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(ImageFileTest, EmptyImageIsRefusedByName) {
  const fs::path file = folder_ / "empty.png";
  EXPECT_THAT(ErrorOf(file, [&] { WriteRgb(file, {}); }), HasSubstr("empty"));
  EXPECT_THAT(ErrorOf(file, [&] { WriteDepth(file, {}); }), HasSubstr("empty"));
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace silt
