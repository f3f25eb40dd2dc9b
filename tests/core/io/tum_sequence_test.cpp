// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/tum_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "posed_image.h"
#include "silt/core/error.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr PinholeCamera kSmall{20, 21, 3.5, 2.5, 8, 6};

class TumSequenceTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("tum_sequence_") + info->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Frame FrameAt(int i) {
    return {100 + i / 60.0, Image<Rgb8>(8, 6, {std::uint8_t(i), 2, 3}),
            Image<float>(8, 6, 1 + 0.1f * float(i))};
  }
  void WriteSequence(int frames) const {
    TumSequenceWriter writer(folder_, Description(frames));
    for (int i = 0; i < frames; ++i) writer.Write(i, FrameAt(i));
    writer.Finish();
  }
  static SequenceDescription Description(int frames) {
    SequenceDescription description{kSmall, {}, {}};
    for (int i = 0; i < frames; ++i) {
      description.truth.push_back({FrameAt(i).time_s, {{}, {double(i), 0, 0}}});
    }
    return description;
  }
  void Overwrite(const char* name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string ErrorOfOpening(const TumSequenceOptions& options = {}) const {
    try {
      TumSequence(folder_, options);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(TumSequenceTest, ReadsWhatWasWritten) {
  WriteSequence(3);
  TumSequence sequence(folder_);
  EXPECT_EQ(sequence.size(), 3);
  EXPECT_EQ(sequence.camera().fx, 20);
  EXPECT_EQ(sequence.camera().fy, 21);
  EXPECT_EQ(sequence.camera().cy, 2.5);
  EXPECT_EQ(sequence.camera().width, 8);
  for (int i = 0; i < 3; ++i) {
    const std::optional<Frame> frame = sequence.Next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->time_s, FrameAt(i).time_s, 1e-9);
    EXPECT_EQ(frame->rgb, FrameAt(i).rgb);
    EXPECT_NEAR(frame->depth_m(7, 5), FrameAt(i).depth_m(7, 5), 1e-4);
  }
  EXPECT_FALSE(sequence.Next());
  EXPECT_FALSE(sequence.Next());
}

// As the benchmark's own scripts would: the intrinsics of camera.txt, the files of the list, depth
// at 5000 per metre along z, and the pose of the image's time, camera to world.
PosedImage ReadAsTum(const fs::path& folder, int number) {
  const auto row = [&folder](const char* list, int index) {
    std::istringstream lines(ReadText(folder / list));
    for (std::string line; std::getline(lines, line);) {
      if (line[0] != '#' && index-- == 0) return line;
    }
    return std::string();
  };
  PosedImage image;
  std::istringstream camera(row("camera.txt", 0));
  double width = 0, height = 0;
  camera >> image.fx >> image.fy >> image.cx >> image.cy >> width >> height;
  LensDistortion& l = image.lens;
  if (!(camera >> std::ws).eof()) camera >> l.k1 >> l.k2 >> l.p1 >> l.p2 >> l.k3;
  std::string time, rgb, depth_time, depth, truth_time;
  std::istringstream(row("associations.txt", number)) >> time >> rgb >> depth_time >> depth;
  image.rgb = ReadRgb(folder / rgb);
  image.gray = GrayFromRgb(image.rgb);
  image.depth_m = ReadDepth(folder / depth, 5000);
  EXPECT_EQ(image.rgb.width(), int(width));
  EXPECT_EQ(image.rgb.height(), int(height));
  Quaterniond q;
  Vec3d& t = image.position;
  std::istringstream(row("groundtruth.txt", number)) >> truth_time >> t.x >> t.y >> t.z >> q.x >>
      q.y >> q.z >> q.w;
  EXPECT_NEAR(std::stod(truth_time), std::stod(time), 1e-9);
  image.rotation = q.Matrix();
  return image;
}

TEST_F(TumSequenceTest, PicturesAreConsistent) {
  for (const LensDistortion& lens : {LensDistortion{}, kBoxLens}) {
    SequenceDescription description = BoxDescription(4);
    description.lens = lens;
    TumSequenceWriter writer(folder_, description);
    WriteBox(writer, description);
    const PosedImage from = ReadAsTum(folder_, 0), to = ReadAsTum(folder_, 3);
    const double right = WarpError(from, to);
    EXPECT_LT(right, 0.6);
    EXPECT_GT(WarpError(WithFyFlipped(from), WithFyFlipped(to)), 10 * right);
    EXPECT_GT(WarpError(WithPoseInverted(from), WithPoseInverted(to)), 10 * right);
    EXPECT_GT(WarpError(WithDepthMistaken(from, -1), WithDepthMistaken(to, -1)), 3 * right);
    const double without_lens = WarpError(WithoutLens(from), WithoutLens(to));
    EXPECT_EQ(without_lens > 3 * right, !lens.IsNone());
  }
}

TEST_F(TumSequenceTest, HoldsEveryPoseColourAndDepthThatWasWritten) {
  const SequenceDescription description = BoxDescription(5);
  const std::vector<Frame> frames = ColoredFrames(description);
  TumSequenceWriter writer(folder_, description);
  for (std::size_t i = 0; i < frames.size(); ++i) writer.Write(int(i), frames[i]);
  writer.Finish();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    ExpectSame(ReadAsTum(folder_, int(i)), description, i, frames[i], 1.0 / 5000);
  }
}

TEST_F(TumSequenceTest, GroundTruthBearsTheFramesTimes) {
  WriteSequence(3);
  const Trajectory truth = ReadTumTrajectory(folder_ / "groundtruth.txt");
  const TumSequence sequence(folder_);
  ASSERT_EQ(truth.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(truth[i].time_s, sequence.entries()[i].time_s);
    EXPECT_EQ(truth[i].world_from_camera.translation.x, double(i));
  }
}

TEST_F(TumSequenceTest, ListsAppearOnlyWithFinish) {
  TumSequenceWriter writer(folder_, Description(1));
  writer.Write(0, FrameAt(0));
  EXPECT_FALSE(fs::exists(folder_ / "associations.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "groundtruth.txt"));
  writer.Finish();
  EXPECT_TRUE(fs::exists(folder_ / "associations.txt"));
  EXPECT_TRUE(fs::exists(folder_ / "groundtruth.txt"));
}

TEST_F(TumSequenceTest, ListsOfAnEarlierSequenceGoWithTheFirstFrame) {
  WriteSequence(3);
  TumSequenceWriter writer(folder_, Description(1));
  EXPECT_EQ(TumSequence(folder_).size(), 3);
  writer.Write(0, FrameAt(0));
  for (const char* list : {"camera.txt", "rgb.txt", "depth.txt", "associations.txt"}) {
    EXPECT_FALSE(fs::exists(folder_ / list)) << list;
  }
}

// As a render does that goes on where it was interrupted.
TEST_F(TumSequenceTest, FramesMayComeInAnyOrderAndAreKnownToBeThere) {
  TumSequenceWriter writer(folder_, Description(3));
  writer.Write(2, FrameAt(2));
  EXPECT_TRUE(HasFrame(folder_, writer, 2));
  EXPECT_FALSE(HasFrame(folder_, writer, 0));
  writer.Write(0, FrameAt(0));
  fs::remove(folder_ / "depth/000000.png");
  EXPECT_FALSE(HasFrame(folder_, writer, 0));
  writer.Write(0, FrameAt(0));
  writer.Write(1, FrameAt(1));
  writer.Finish();
  TumSequence sequence(folder_);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(sequence.Next()->rgb, FrameAt(i).rgb) << i;
}

TEST_F(TumSequenceTest, TakeEveryThins) {
  WriteSequence(7);
  const TumSequence sequence(folder_, {.take_every = 3});
  ASSERT_EQ(sequence.size(), 3);
  EXPECT_NEAR(sequence.entries()[1].time_s, 100 + 3 / 60.0, 1e-9);
  EXPECT_NEAR(sequence.entries()[2].time_s, 100 + 6 / 60.0, 1e-9);
}

TEST_F(TumSequenceTest, GivenCameraReplacesTheFile) {
  WriteSequence(1);
  fs::remove(folder_ / "camera.txt");
  PinholeCamera camera = kSmall;
  camera.fx = 30;
  EXPECT_EQ(TumSequence(folder_, {}, camera).camera().fx, 30);
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("camera.txt: expected one line"));
}

TEST_F(TumSequenceTest, ALensIsWrittenAndRefusedByTheReaderOfPinholes) {
  SequenceDescription description = Description(1);
  description.lens = {-0.25, 0.0625, 0.001, -0.002, 0.5};
  TumSequenceWriter writer(folder_, description);
  writer.Write(0, FrameAt(0));
  writer.Finish();
  std::ifstream camera(folder_ / "camera.txt");
  std::string line;
  std::getline(camera, line);
  std::getline(camera, line);
  EXPECT_EQ(line, "20 21 3.5 2.5 8 6 -0.25 0.0625 0.001 -0.002 0.5");
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("camera.txt:2: the lens has distortion"));
}

TEST_F(TumSequenceTest, ACameraWithoutASizeTakesTheFirstImages) {
  WriteSequence(1);
  const PinholeCamera camera = TumSequence(folder_, {}, {30, 31, 3, 2}).camera();
  EXPECT_EQ(camera.fx, 30);
  EXPECT_EQ(camera.width, kSmall.width);
  EXPECT_EQ(camera.height, kSmall.height);
}

// As in TUM's own folders: two lists, times that differ, a depth image missing.
TEST_F(TumSequenceTest, AssociatesTheNearestDepthWithinTheTolerance) {
  WriteSequence(3);
  fs::remove(folder_ / "associations.txt");
  Overwrite("rgb.txt",
            "# color images\n1.000 rgb/000000.png\n1.033 rgb/000001.png\n"
            "1.100 rgb/000002.png\n");
  Overwrite("depth.txt",
            "0.985 depth/000000.png\n1.004 depth/000001.png\n1.051 depth/000002.png\n");
  TumSequence sequence(folder_);
  ASSERT_EQ(sequence.size(), 3);
  EXPECT_EQ(sequence.entries()[0].depth.filename(), "000001.png");
  EXPECT_EQ(sequence.entries()[1].depth.filename(), "000002.png");
  EXPECT_TRUE(sequence.entries()[2].depth.empty());
  sequence.Next();
  sequence.Next();
  EXPECT_TRUE(sequence.Next()->depth_m.empty());
  const TumSequence strict(folder_, {.association_tolerance_s = 0.01});
  EXPECT_FALSE(strict.entries()[0].depth.empty());
  EXPECT_TRUE(strict.entries()[1].depth.empty());
}

struct BadList {
  const char* file;
  const char* text;
  const char* complaint;
};
void PrintTo(const BadList& bad, std::ostream* out) { *out << bad.file << bad.complaint; }

class BadTumList : public TumSequenceTest, public testing::WithParamInterface<BadList> {
 protected:
  // Parameterised names hold slashes.
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("tum_bad_list_" + std::to_string(std::hash<std::string>()(GetParam().text)));
    fs::remove_all(folder_);
  }
};

TEST_P(BadTumList, IsRefusedWithFileAndLine) {
  WriteSequence(2);
  if (std::string(GetParam().file) != "associations.txt") fs::remove(folder_ / "associations.txt");
  Overwrite(GetParam().file, GetParam().text);
  const std::string error = ErrorOfOpening();
  EXPECT_THAT(error, HasSubstr(std::string(GetParam().file) + GetParam().complaint));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Lists, BadTumList,
    testing::Values(
        BadList{"associations.txt", "# c\n\n1 a.png 1\n", ":3: expected: time rgb time depth"},
        BadList{"associations.txt", "x a.png 1 b.png\n", ":1: 'x' is not a number"},
        BadList{"associations.txt", "1 a.png y b.png\n", ":1: 'y' is not a number"},
        BadList{"associations.txt", "1 a.png 1 b.png\n1 c.png 1 d.png\n",
                ":2: time does not increase"},
        BadList{"rgb.txt", "1 a.png\n2\n", ":2: expected: time file"},
        BadList{"rgb.txt", "nan a.png\n", ":1: 'nan' is not a number"},
        BadList{"depth.txt", "1 a.png extra\n", ":1: expected: time file"},
        BadList{"depth.txt", "2 a.png\n1 b.png\n", ":2: time does not increase"},
        BadList{"camera.txt", "1 2 3 4 5\n", ": expected one line"},
        BadList{"camera.txt", "1 2 3 4 5 6\n1 2 3 4 5 6\n", ": expected one line"},
        BadList{"camera.txt", "# f\n0 1 2 3 8 6\n", ":2: fx and fy must be positive"},
        BadList{"camera.txt", "20 -21 2 3 8 6\n", ":1: fx and fy must be positive"},
        BadList{"camera.txt", "20 20 2 3 8.5 6\n", ":1: width and height must be whole"},
        BadList{"camera.txt", "20 20 2 3 0 6\n", ":1: width and height must be whole"},
        BadList{"camera.txt", "20 20 2 3 8 1e12\n", ":1: width and height must be whole"}));

TEST_F(TumSequenceTest, MissingPartsAreNamed) {
  EXPECT_THAT(ErrorOfOpening(), HasSubstr(folder_.string() + ": no such sequence folder"));
  WriteSequence(1);
  Overwrite("associations.txt", "# nothing\n");
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("lists no image"));
  fs::remove(folder_ / "associations.txt");
  fs::remove(folder_ / "rgb.txt");
  EXPECT_THAT(ErrorOfOpening(), HasSubstr("rgb.txt: no such list"));
}

TEST_F(TumSequenceTest, MissingOrWrongImageIsNamedWhenItsTurnComes) {
  WriteSequence(3);
  fs::remove(folder_ / "rgb" / "000001.png");
  WriteDepth(folder_ / "depth" / "000002.png", Image<float>(4, 6, 1.0f));
  TumSequence sequence(folder_);
  EXPECT_TRUE(sequence.Next());
  for (const char* name : {"rgb/000001.png", "depth/000002.png"}) {
    try {
      sequence.Next();
      ADD_FAILURE() << name;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace silt
