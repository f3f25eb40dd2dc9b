// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "silt/core/io/image_file.h"
#include "silt/core/io/sequence_format.h"
#include "silt_program.h"

// `silt render` and `silt convert` as they are called.
namespace silt::experiments {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string Quoted(const fs::path& path) { return "'" + path.string() + "'"; }

// Six small frames of the studio, or as many as `more` asks for.
constexpr const char* kStretch = "render --scene studio --width 64 --spp 1 --fps 20 --seed 3 ";

// All files below a folder but the manifest, which holds the date.
std::map<std::string, std::string> Contents(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename() == "manifest.json") continue;
    contents[fs::relative(entry.path(), folder).string()] = ReadText(entry.path());
  }
  return contents;
}

class RenderCommand : public testing::Test {
 protected:
  ProgramResult Run(const std::string& out, const std::string& more = "",
                    const std::string& before = "") const {
    const bool timed = more.find("--duration") != more.npos;
    return RunSilt(
        kStretch + more + (timed ? "" : " --duration 0.3") + " --out " + Quoted(folder_ / out),
        before);
  }
  TestFolder folder_;
};

// The first file of the third frame in each layout.
const std::map<std::string, std::string> kThirdFile{
    {"tum", "rgb/000002.png"},
    {"icl", "scene_00_0002.png"},
    {"euroc", "mav0/cam0/data/0000000000100000000.png"},
    {"nerfstudio", "images/000002.png"},
    {"colmap", "images/000002.png"},
    {"raw", "frames/000002.raw"}};

class RenderFormat : public RenderCommand, public testing::WithParamInterface<std::string> {};

// The promise: killed at any moment, the same command goes on and ends with the same bytes.
TEST_P(RenderFormat, KilledAndResumedIsTheSameBytes) {
  const std::string more = "--duration 1 --truth all --imu-noise euroc --format " + GetParam();
  ASSERT_EQ(Run("whole", more).exit_code, 0);
  const fs::path cut = folder_ / "cut";
  const std::string third = kThirdFile.at(GetParam());
  // The shell kills its child as soon as the third frame's first file is there.
  const std::string kill = "f() { \"$@\" & p=$!; while [ ! -e " + Quoted(cut / third) +
                           " ] && kill -0 $p 2> /dev/null; do sleep 0.001; done; "
                           "kill -9 $p; wait $p; }; f";
  // On a busy machine the render may come to its end first: try again.
  for (int i = 0; i < 20 && !fs::exists(cut / "unfinished.json"); ++i) {
    fs::remove_all(cut);
    Run("cut", more, kill);
  }
  ASSERT_TRUE(fs::exists(cut / "unfinished.json"));
  ASSERT_FALSE(fs::exists(cut / "manifest.json"));
  const ProgramResult resumed = Run("cut", more);
  ASSERT_EQ(resumed.exit_code, 0) << resumed.error;
  EXPECT_THAT(resumed.out, HasSubstr("of them new"));
  EXPECT_EQ(Contents(cut), Contents(folder_ / "whole"));
  EXPECT_TRUE(fs::exists(cut / "manifest.json"));
}

INSTANTIATE_TEST_SUITE_P(Formats, RenderFormat, testing::ValuesIn(SequenceFormats()),
                         [](const auto& param) { return param.param; });

// A scene of a model with a texture, a recorded path and a response table, each in a file that the
// command line does not name.
class RenderOfFiles : public testing::Test {
 protected:
  void SetUp() override {
    Write("scene.toml",
          "name = \"Sheet\"\nambient = [1, 1, 1]\n[[material]]\nname = \"paint\"\n"
          "texture = \"picture.png\"\n[[model]]\nfile = \"sheet.obj\"\nup = \"z\"\n"
          "materials = { \"*\" = \"paint\" }\n");
    Write("sheet.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    WriteRgb(folder_ / "picture.png", Image<Rgb8>(4, 4, {200, 100, 50}));
    Write("path.toml", "[replay]\nfile = \"recorded.txt\"\n");
    Write("recorded.txt", "0 0 0 2 1 0 0 0\n0.5 0.1 0 2 1 0 0 0\n1 0.2 0 2 1 0 0 0\n");
    Write("sensor.toml", "response = \"table.txt\"\n");
    Write("table.txt", "0 0\n0.5 0.7\n1 1\n");
  }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  ProgramResult Run() const {
    return RunSilt("render --scene " + Quoted(folder_ / "scene.toml") + " --trajectory " +
                   Quoted(folder_ / "path.toml") + " --sensor " + Quoted(folder_ / "sensor.toml") +
                   " --width 16 --spp 1 --fps 10 --duration 0.3 --allow-crossing --out " +
                   Quoted(folder_ / "seq"));
  }
  TestFolder folder_;
};

// Old frames and new ones would lie side by side in one sequence.
TEST_F(RenderOfFiles, GoesOnOnlyWithTheSceneRecordingAndTableThatItBeganWith) {
  ASSERT_EQ(Run().exit_code, 0);
  fs::remove(folder_ / "seq/rgb/000001.png");
  const auto left = Contents(folder_ / "seq");
  const auto refused = [&](const std::string& key) {
    ExpectOneLineError(Run(), "holds another render (" + key + " is ");
    EXPECT_EQ(Contents(folder_ / "seq"), left);
    SetUp();
  };
  WriteRgb(folder_ / "picture.png", Image<Rgb8>(4, 4, {200, 100, 51}));
  refused("world/scene_contents_hash");
  Write("sheet.obj", "v 0 0 0\nv 2 0 0\nv 0 2.001 0\nf 1 2 3\n");
  refused("world/scene_contents_hash");
  Write("recorded.txt", "0 0 0 2 1 0 0 0\n0.5 0.1 0 2 1 0 0 0\n1 0.2001 0 2 1 0 0 0\n");
  refused("world/path_poses_hash");
  Write("table.txt", "0 0\n0.5 0.71\n1 1\n");
  refused("render/response_hash");
  const ProgramResult unchanged = Run();
  EXPECT_EQ(unchanged.exit_code, 0) << unchanged.error;
  EXPECT_THAT(unchanged.out, HasSubstr("1 of them new"));
}

TEST_F(RenderCommand, MissingFramesComeBackAndNothingElseIsTouched) {
  ASSERT_EQ(Run("seq").exit_code, 0);
  const auto before = Contents(folder_ / "seq");
  fs::remove(folder_ / "seq/depth/000004.png");
  const auto time = fs::last_write_time(folder_ / "seq/rgb/000001.png");
  const ProgramResult again = Run("seq");
  EXPECT_THAT(again.out, HasSubstr("6 frames in"));
  EXPECT_THAT(again.out, HasSubstr("1 of them new"));
  EXPECT_EQ(Contents(folder_ / "seq"), before);
  EXPECT_EQ(fs::last_write_time(folder_ / "seq/rgb/000001.png"), time);
  EXPECT_THAT(Run("seq").out, HasSubstr("6 frames are in"));
}

TEST_F(RenderCommand, AnotherConfigurationIsRefusedUnlessToldToOverwrite) {
  ASSERT_EQ(Run("seq").exit_code, 0);
  const auto before = Contents(folder_ / "seq");
  ExpectOneLineError(Run("seq", "--blur full"), "render/exposure_s is 0.0 there and 0.05 here");
  EXPECT_EQ(Contents(folder_ / "seq"), before);
  EXPECT_EQ(Run("seq", "--blur full --overwrite").exit_code, 0);
  EXPECT_NE(Contents(folder_ / "seq"), before);
  EXPECT_EQ(Contents(folder_ / "seq").size(), before.size());
}

TEST_F(RenderCommand, BadOptionsAndPlacesAreToldInOneLine) {
  ExpectOneLineError(Run("a", "--truth depth,colour"), "colour");
  ExpectOneLineError(Run("a", "--format bag"), "bag");
  ExpectOneLineError(Run("a", "--imu-rate 0"), "--imu-rate: '0' is not a number from 1");
  ExpectOneLineError(RunSilt(std::string(kStretch) + "--duration 0.3 --out /proc/silt"),
                     "/proc/silt: cannot be written");
  ExpectOneLineError(RunSilt(std::string(kStretch) + "--duration 0.3 --out /dev/null"),
                     "is no folder");
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

// A limit on the size of files stands for a full disk: pictures fit, the list of the IMU's states
// does not.
TEST_F(RenderCommand, OnADiskThatFillsUpWholeFramesStayAndTheRestComesLater) {
  const std::string more = "--format euroc --imu-rate 1000";
  ExpectOneLineError(Run("seq", more, "trap '' XFSZ; ulimit -f 32;"),
                     "data.csv: cannot be written");
  EXPECT_TRUE(fs::exists(folder_ / "seq/unfinished.json"));
  for (const auto& [name, bytes] : Contents(folder_ / "seq")) {
    EXPECT_EQ(name.find(".part-"), name.npos) << name;
  }
  EXPECT_THAT(Run("seq", more).out, HasSubstr("6 frames in"));
  ASSERT_EQ(Run("whole", more).exit_code, 0);
  EXPECT_EQ(Contents(folder_ / "seq"), Contents(folder_ / "whole"));
}

TEST_F(RenderCommand, OnADiskThatIsFullNothingIsLeft) {
  ExpectOneLineError(Run("seq", "", "trap '' XFSZ; ulimit -f 4;"), "cannot be written");
  EXPECT_FALSE(fs::exists(folder_ / "seq"));
}

TEST_F(RenderCommand, WritesTheTruthThatWasAskedForAndNoOther) {
  ASSERT_EQ(Run("ids", "--truth ids").exit_code, 0);
  const fs::path truth = folder_ / "ids/truth";
  const auto legend = nlohmann::json::parse(ReadText(truth / "legend.json"));
  const Image<std::uint16_t> ids = ReadGray16(truth / "instance/000002.png");
  ASSERT_EQ(ids.width(), 64);
  int named = 0;
  for (const std::uint16_t id : ids) named += legend["instance"].contains(std::to_string(id));
  EXPECT_EQ(named, 64 * 48);
  EXPECT_GT(legend["material"].size(), 2u);
  EXPECT_FALSE(fs::exists(truth / "depth_z"));
  EXPECT_FALSE(fs::exists(truth / "imu.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "ids/truth/poses.txt"));
  ASSERT_EQ(Run("none").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "none/truth"));
}

// Along the ray is along z times the ray's length, and both are the frame's own depth.
TEST_F(RenderCommand, DepthsAgree) {
  ASSERT_EQ(Run("seq", "--truth depth,poses --pose-rate 100").exit_code, 0);
  const Image<float> frame = ReadDepth(folder_ / "seq/depth/000003.png");
  const PinholeCamera camera = OpenSequence("auto", folder_ / "seq")->camera();
  const auto load = [&](const char* kind) {
    const std::string bytes = ReadText(folder_ / "seq/truth" / kind / "000003.npy");
    Image<float> image(64, 48);
    std::copy_n(bytes.data() + bytes.size() - image.size() * 4, image.size() * 4,
                reinterpret_cast<char*>(image.data()));
    return image;
  };
  const Image<float> z = load("depth_z"), ray = load("depth_ray");
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      EXPECT_NEAR(z(x, y), frame(x, y), 1.01e-4);
      EXPECT_NEAR(ray(x, y), z(x, y) * Norm(camera.Unproject(double(x), double(y), 1.0)), 1e-5);
    }
  }
  EXPECT_EQ(ReadTumTrajectory(folder_ / "seq/truth/poses.txt").size(), 30u);
}

// Each pair of layouts that can be read: there and back the truth and the pictures are the same.
TEST_F(RenderCommand, ConvertedThereAndBackIsTheSame) {
  ASSERT_EQ(Run("tum").exit_code, 0);
  std::string last = "tum";
  for (const char* format : {"icl", "raw", "icl", "tum"}) {
    const std::string next = last + "-" + format;
    const ProgramResult result = RunSilt("convert " + Quoted(folder_ / last) + " " +
                                         Quoted(folder_ / next) + " --to " + format);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    last = next;
  }
  for (const char* name : {"camera.txt", "rgb/000005.png", "depth/000005.png"}) {
    EXPECT_EQ(ReadText(folder_ / "tum" / name), ReadText(folder_ / last / name)) << name;
  }
  const Trajectory before = ReadTumTrajectory(folder_ / "tum/groundtruth.txt"),
                   after = ReadTumTrajectory(folder_ / last / "groundtruth.txt");
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const SE3d gap = before[i].world_from_camera.Inverse() * after[i].world_from_camera;
    EXPECT_LT(Norm(gap.translation) + RotationAngle(gap.rotation), 1e-7);
  }
}

TEST_F(RenderCommand, ConvertLeavesOutFramesWithoutATruePose) {
  ASSERT_EQ(Run("tum").exit_code, 0);
  Trajectory truth = ReadTumTrajectory(folder_ / "tum/groundtruth.txt");
  truth.resize(4);
  WriteTumTrajectory(folder_ / "tum/groundtruth.txt", truth);
  const ProgramResult some =
      RunSilt("convert " + Quoted(folder_ / "tum") + " " + Quoted(folder_ / "raw") + " --to raw");
  EXPECT_EQ(some.exit_code, 0);
  EXPECT_THAT(some.error, HasSubstr("2 frames without a true pose are left out"));
  EXPECT_THAT(some.out, HasSubstr("4 frames"));
  fs::remove(folder_ / "tum/groundtruth.txt");
  ExpectOneLineError(
      RunSilt("convert " + Quoted(folder_ / "tum") + " " + Quoted(folder_ / "none") + " --to raw"),
      "no frame has a true pose");
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(RenderCommand, TrackReadsEveryLayoutThatCanBeRead) {
  ASSERT_EQ(RunSilt("render --scene studio --width 320 --spp 1 --fps 20 --duration 0.15 --out " +
                    Quoted(folder_ / "tum"))
                .exit_code,
            0);
  std::string first;
  for (const std::string& format : ReadableFormats()) {
    const std::string place = format == "tum" ? "tum" : "as-" + format;
    if (format != "tum") {
      ASSERT_EQ(RunSilt("convert " + Quoted(folder_ / "tum") + " " + Quoted(folder_ / place) +
                        " --to " + format)
                    .exit_code,
                0);
    }
    const ProgramResult tracked = RunSilt("track " + Quoted(folder_ / place) + " --out " +
                                          Quoted(folder_ / (format + ".txt")));
    ASSERT_EQ(tracked.exit_code, 0) << tracked.error;
    const Trajectory estimate = ReadTumTrajectory(folder_ / (format + ".txt"));
    const Trajectory reference = ReadTumTrajectory(folder_ / "tum.txt");
    ASSERT_EQ(estimate.size(), 3u);
    const SE3d gap =
        estimate.back().world_from_camera.Inverse() * reference.back().world_from_camera;
    EXPECT_LT(Norm(gap.translation) + RotationAngle(gap.rotation), 2e-4) << format;
  }
}

}  // namespace
}  // namespace silt::experiments
