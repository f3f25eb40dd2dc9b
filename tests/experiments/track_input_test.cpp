// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/io/icl_camera.h"
#include "silt/core/io/image_file.h"
#include "silt/core/trajectory.h"
#include "silt_program.h"

// What `silt track` makes of folders as people have them.
namespace silt::experiments {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Ten frames of the studio, rendered once per process.
class TrackInput : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    rendered_ = new TestFolder;
    for (const char* layout : {"tum", "icl"}) {
      const ProgramResult result =
          RunSilt("render --scene studio --width 160 --spp 1 --fps 20 --duration 0.5 --format " +
                  std::string(layout) + " --out " + (*rendered_ / layout).string());
      ASSERT_EQ(result.exit_code, 0) << result.error;
    }
  }
  static void TearDownTestSuite() { delete rendered_; }
  void SetUp() override { fs::copy(*rendered_ / "tum", seq_, fs::copy_options::recursive); }

  // Colours at 0, 0.05, … s and depths `late_s` after them, of which some are missing.
  void Unsynchronise(double late_s, const std::vector<int>& missing = {}) const {
    fs::remove(seq_ / "associations.txt");
    std::ofstream depth(seq_ / "depth.txt");
    for (int i = 0; i < 10; ++i) {
      if (std::find(missing.begin(), missing.end(), i) != missing.end()) continue;
      char line[80];
      std::snprintf(line, sizeof line, "%.6f depth/%06d.png\n", 0.05 * i + late_s, i);
      depth << line;
    }
  }

  nlohmann::json Track(const fs::path& folder, const std::string& options = "") const {
    const ProgramResult result =
        RunSilt("track " + folder.string() + " --preset fast --json " + json_.string() + " --out " +
                out_.string() + " " + options);
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return nlohmann::json::parse(ReadText(json_), nullptr, false);
  }

  static double Rmse_cm(const nlohmann::json& json) {
    return json["evaluation"]["position_cm"]["rmse"];
  }

  static inline TestFolder* rendered_ = nullptr;
  TestFolder folder_;
  const fs::path seq_ = folder_ / "seq", json_ = folder_ / "a.json", out_ = folder_ / "a.txt";
};

TEST_F(TrackInput, TellsTheStatusOfEachFrame) {
  const auto json = Track(seq_);
  ASSERT_EQ(json["per_frame"].size(), 10u);
  EXPECT_EQ(json["lost"], 0);
  for (const auto& frame : json["per_frame"]) {
    EXPECT_EQ(frame["status"], "tracked");
    EXPECT_EQ(frame["covariance"].size(), 36u);
  }
  EXPECT_EQ(json["per_frame"][0]["keyframe"], true);
  EXPECT_EQ(json["per_frame"][0]["position_deviation_m"], 0);
  EXPECT_GT(json["per_frame"][9]["position_deviation_m"], 0);
  EXPECT_LT(json["per_frame"][9]["position_deviation_m"], 0.01);
}

TEST_F(TrackInput, AGraphWorksAfterwardsOrInTheBackground) {
  EXPECT_TRUE(Track(seq_)["graph"].is_null());
  const auto afterwards = Track(seq_, "--graph"), background = Track(seq_, "--graph=background");
  EXPECT_TRUE(afterwards["graph"].contains("edges"));
  EXPECT_FALSE(afterwards["graph"].contains("waited_ms"));
  EXPECT_TRUE(background["graph"].contains("waited_ms"));
  EXPECT_LT(Rmse_cm(background), 2 * Rmse_cm(Track(seq_)));
}

TEST_F(TrackInput, SkipsFrames) {
  const auto json = Track(seq_, "--fps-skip 3");
  EXPECT_EQ(json["frames"], 4);
  const Trajectory estimate = ReadTumTrajectory(out_);
  ASSERT_EQ(estimate.size(), 4u);
  EXPECT_NEAR(estimate[1].time_s, 0.15, 1e-9);
  EXPECT_LT(Rmse_cm(json), 0.5);
}

TEST_F(TrackInput, AssociatesListsWithinTheTolerance) {
  Unsynchronise(0.024);
  // Nothing within 0.02 s: a first depth never comes.
  const auto none = Track(seq_);
  EXPECT_EQ(none["lost"], 10);
  EXPECT_EQ(none["keyframes"], 0);
  const auto all = Track(seq_, "--tolerance 0.0245");
  EXPECT_EQ(all["lost"], 0);
  EXPECT_LT(Rmse_cm(all), 0.5);
}

TEST_F(TrackInput, DoesWithoutTheDepthOfSomeFrames) {
  Unsynchronise(0.001, {2, 3, 7});
  const auto json = Track(seq_);
  EXPECT_EQ(json["frames"], 10);
  EXPECT_EQ(json["lost"], 0);
  EXPECT_LT(Rmse_cm(json), 0.5);
}

TEST_F(TrackInput, TakesGrayAndSixteenBits) {
  for (int i = 0; i < 10; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "%06d.png", i);
    const fs::path file = seq_ / "rgb" / name;
    const Image<Rgb8> rgb = ReadRgb(file);
    Image<std::uint16_t> wide(rgb.width(), rgb.height());
    Image<std::uint8_t> narrow(rgb.width(), rgb.height());
    for (std::size_t k = 0; k < rgb.size(); ++k) {
      narrow.data()[k] = rgb.data()[k].g;
      wide.data()[k] = std::uint16_t(257 * rgb.data()[k].g);
    }
    i % 2 == 0 ? WriteGray(file, wide) : WriteGray(file, narrow);
  }
  const auto json = Track(seq_);
  EXPECT_EQ(json["lost"], 0);
  EXPECT_LT(Rmse_cm(json), 0.5);
}

TEST_F(TrackInput, ReadsIclsLayout) {
  const auto json = Track(*rendered_ / "icl", "--fps-skip 2");
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(json["lost"], 0);
  EXPECT_LT(Rmse_cm(json), 0.5);
}

// ICL-NUIM's TUM folders: poses in its axes, fy negative. The estimate is in the same axes.
TEST_F(TrackInput, ANegativeFyMeansIclsAxes) {
  Trajectory truth = ReadTumTrajectory(seq_ / "groundtruth.txt");
  for (StampedPose& pose : truth) pose.world_from_camera = IclFromSilt(pose.world_from_camera);
  WriteTumTrajectory(seq_ / "groundtruth.txt", truth);
  const auto json = Track(seq_, "--camera 120.3 -120 79.5 59.5");
  EXPECT_LT(Rmse_cm(json), 0.5);
  const Trajectory estimate = ReadTumTrajectory(out_);
  ASSERT_EQ(estimate.size(), 10u);
  const SE3d gap = truth[9].world_from_camera.Inverse() * estimate[9].world_from_camera;
  EXPECT_LT(Norm(gap.translation), 0.005);
  EXPECT_LT(RotationAngle(gap.rotation), 0.01);
}

struct Spoiled {
  const char* file;
  const char* text;  // nothing: the file is removed
  const char* complaint;
};
void PrintTo(const Spoiled& spoiled, std::ostream* out) {
  *out << spoiled.file << ' ' << spoiled.complaint;
}

class BadTrackInput : public TrackInput, public testing::WithParamInterface<Spoiled> {};

TEST_P(BadTrackInput, IsToldInOneLine) {
  fs::remove(seq_ / "associations.txt");
  fs::remove(seq_ / GetParam().file);
  if (GetParam().text != nullptr) std::ofstream(seq_ / GetParam().file) << GetParam().text;
  const ProgramResult result = RunSilt("track " + seq_.string() + " --out " + out_.string());
  EXPECT_EQ(result.exit_code, 1);
  ExpectOneLineError(result, GetParam().file);
  EXPECT_THAT(result.error, HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(Files, BadTrackInput,
                         testing::Values(Spoiled{"depth.txt", nullptr, "no such list"},
                                         Spoiled{"depth.txt", "0.0 depth/000000.png\n0.0 x.png\n",
                                                 ":2: time does not"},
                                         Spoiled{"rgb.txt", "0.0\n", ":1: expected: time file"},
                                         Spoiled{"depth/000000.png", nullptr, "no such image file"},
                                         Spoiled{"rgb/000003.png", "PNG", "is not an image"},
                                         Spoiled{"camera.txt", "1 2 3\n", "expected one line"}));

}  // namespace
}  // namespace silt::experiments
