// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/raw_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "silt/core/error.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RawSequenceTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("raw_sequence_") + info->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static RawFrame FrameAt(int i) {
    RawFrame raw{{20, 21, 3.5, 2.5, 8, 6},
                 SE3d::Exp({{0.1 * i, 0.2, 0.3}, {1, 2, double(i)}}),
                 {0.5 * i, Image<Rgb8>(8, 6, {1, 2, 3}), Image<float>(8, 6, 1.5f)}};
    raw.frame.rgb(7, 5) = {std::uint8_t(i), 8, 9};
    raw.frame.depth_m(6, 5) = float(i);
    return raw;
  }
  void Write(int frames) const {
    std::string list = "# frames\n";
    for (int i = 0; i < frames; ++i) {
      const std::string name = std::to_string(i) + ".raw";
      WriteRawFrame(folder_ / name, FrameAt(i));
      list += name + "\n";
    }
    std::ofstream(folder_ / "frames.txt") << list;
  }
  std::string Bytes(const char* name) const {
    std::ostringstream bytes;
    bytes << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return bytes.str();
  }
  // Puts a value into frame 1's file and tells what reading the folder says.
  template <typename T>
  std::string ErrorWith(std::size_t offset, T value) const {
    Write(2);
    std::string bytes = Bytes("1.raw");
    std::memcpy(bytes.data() + offset, &value, sizeof value);
    std::ofstream(folder_ / "1.raw", std::ios::binary) << bytes;
    return ErrorOfOpening();
  }
  std::string ErrorOfOpening() const {
    try {
      RawSequence sequence(folder_);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(RawSequenceTest, ReadsWhatWasWrittenToTheLastBit) {
  Write(3);
  RawSequence sequence(folder_);
  ASSERT_EQ(sequence.size(), 3);
  EXPECT_EQ(sequence.camera().fy, 21);
  EXPECT_EQ(sequence.camera().width, 8);
  EXPECT_EQ(sequence.times_s(), (std::vector<double>{0, 0.5, 1}));
  for (int i = 0; i < 3; ++i) {
    const RawFrame expected = FrameAt(i);
    const std::optional<Frame> frame = sequence.Next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->time_s, expected.frame.time_s);
    EXPECT_EQ(frame->rgb, expected.frame.rgb);
    EXPECT_EQ(frame->depth_m, expected.frame.depth_m);
    const SE3d& pose = sequence.truth()[std::size_t(i)].world_from_camera;
    EXPECT_EQ(pose.translation.z, expected.world_from_camera.translation.z);
    EXPECT_EQ(pose.rotation.w, expected.world_from_camera.rotation.w);
    EXPECT_EQ(pose.rotation.x, expected.world_from_camera.rotation.x);
  }
  EXPECT_FALSE(sequence.Next());
}

// Other programs rely on these offsets.
TEST_F(RawSequenceTest, BytesLieWhereTheHeaderSays) {
  Write(2);
  const std::string bytes = Bytes("1.raw");
  ASSERT_EQ(bytes.size(), 128u + 8 * 6 * 7);
  EXPECT_EQ(bytes.substr(0, 8), "SILTRAW1");
  const auto at = [&](std::size_t offset, auto value) {
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
  };
  EXPECT_EQ(at(8, std::uint32_t()), 8u);
  EXPECT_EQ(at(12, std::uint32_t()), 6u);
  EXPECT_EQ(at(16, std::uint32_t()), 3u);
  EXPECT_EQ(at(20, std::uint32_t()), 1u);
  EXPECT_EQ(at(24, 0.0), 0.5);
  EXPECT_EQ(at(40, 0.0), 21);
  EXPECT_EQ(at(64, 0.0), FrameAt(1).world_from_camera.translation.x);
  EXPECT_EQ(at(112, 0.0), FrameAt(1).world_from_camera.rotation.w);
  EXPECT_EQ(bytes[128 + 3 * 47], 1);  // red of the last pixel
  EXPECT_EQ(at(128 + 3 * 48 + 4 * 46, 0.0f), 1);
}

TEST_F(RawSequenceTest, DepthMayBeMissing) {
  RawFrame raw = FrameAt(0);
  raw.frame.depth_m = {};
  WriteRawFrame(folder_ / "a.raw", raw);
  EXPECT_TRUE(ReadRawFrame(folder_ / "a.raw").frame.depth_m.empty());
  EXPECT_EQ(ReadRawFrame(folder_ / "a.raw").frame.rgb, raw.frame.rgb);
}

TEST_F(RawSequenceTest, DamageIsNamed) {
  const double nan = std::nan("");
  EXPECT_THAT(ErrorWith(0, 'X'), HasSubstr("1.raw: is not a frame of silt's raw layout"));
  EXPECT_THAT(ErrorWith(8, std::uint32_t(0)), HasSubstr("1.raw: its header is damaged"));
  EXPECT_THAT(ErrorWith(8, std::uint32_t(4000000000u)), HasSubstr("its header is damaged"));
  EXPECT_THAT(ErrorWith(12, std::uint32_t(7)), HasSubstr("its size is not that"));
  EXPECT_THAT(ErrorWith(16, std::uint32_t(4)), HasSubstr("its header is damaged"));
  EXPECT_THAT(ErrorWith(20, std::uint32_t(2)), HasSubstr("its header is damaged"));
  EXPECT_THAT(ErrorWith(24, nan), HasSubstr("its header is damaged"));
  EXPECT_THAT(ErrorWith(24, 0.0), HasSubstr("its time is not later"));
  EXPECT_THAT(ErrorWith(32, -20.0), HasSubstr("its header is damaged"));
  EXPECT_THAT(ErrorWith(32, 22.0), HasSubstr("its camera differs"));
  EXPECT_THAT(ErrorWith(112, 5.0), HasSubstr("its header is damaged"));
}

TEST_F(RawSequenceTest, MissingPartsAreNamed) {
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("frames.txt: cannot be read"));
  Write(2);
  fs::resize_file(folder_ / "1.raw", 200);
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("1.raw: its size"));
  fs::resize_file(folder_ / "1.raw", 20);
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("1.raw: is not a frame"));
  fs::remove(folder_ / "1.raw");
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("1.raw: cannot be read"));
  std::ofstream(folder_ / "frames.txt") << "# none\n";
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("lists no frame"));
}

}  // namespace
}  // namespace silt
