// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/align.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "silt/core/io/image_file.h"
#include "silt/core/trajectory.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

double Distance(const SE3d& a, const SE3d& b) {
  return Norm((a * b.Inverse()).translation) + 2 * Norm((a * b.Inverse()).rotation.Log());
}

SE3d PoseOf(const Json& matrix) {
  std::array<double, 16> m = matrix;
  SE3d pose;
  pose.translation = {m[3], m[7], m[11]};
  const double w = 0.5 * std::sqrt(1 + m[0] + m[5] + m[10]);
  pose.rotation = {w, (m[9] - m[6]) / (4 * w), (m[2] - m[8]) / (4 * w), (m[4] - m[1]) / (4 * w)};
  return pose;
}

// A second of the studio, rendered once for all tests of a process.
class AlignCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TestFolder;
    const ProgramResult rendered =
        RunSilt("render --scene studio --fps 10 --duration 0.5 --width 320 --out " +
                (*folder_ / "s").string());
    ASSERT_EQ(rendered.exit_code, 0) << rendered.error;
    truth_ = new Trajectory(ReadTumTrajectory(*folder_ / "s/groundtruth.txt"));
    std::ifstream lists(*folder_ / "s/associations.txt");
    for (std::string line, time, rgb, depth; std::getline(lists, line);) {
      std::istringstream words(line);
      if (!line.starts_with('#') && words >> time >> rgb >> time >> depth) {
        files_.push_back({rgb, depth});
      }
    }
    ASSERT_EQ(files_.size(), truth_->size());
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete truth_;
    files_.clear();
  }

  static std::string Path(const std::string& name) { return (*folder_ / "s" / name).string(); }
  static std::string Ref(std::size_t i) {
    return " --ref " + Path(files_[i].first) + " " + Path(files_[i].second);
  }
  // What is written of one pair.
  static Json Pair(const std::string& arguments) {
    const ProgramResult result = RunSilt(arguments + " --json -");
    EXPECT_EQ(result.exit_code, 0) << result.error;
    return Json::parse(result.out)["pairs"][0];
  }
  static SE3d Truth(std::size_t reference, std::size_t current) {
    return (*truth_)[current].world_from_camera.Inverse() * (*truth_)[reference].world_from_camera;
  }

  static TestFolder* folder_;
  static Trajectory* truth_;
  static std::vector<std::pair<std::string, std::string>> files_;
};

TestFolder* AlignCommand::folder_ = nullptr;
Trajectory* AlignCommand::truth_ = nullptr;
std::vector<std::pair<std::string, std::string>> AlignCommand::files_;

const std::string kCamera = " --camera 240.6 240 159.5 119.5";

TEST_F(AlignCommand, FindsTheMotionOfEveryPairOfAList) {
  std::ofstream list(*folder_ / "s/pairs.txt");
  list << "# with and without the current depth\n\n";
  list << files_[0].first << " " << files_[0].second << " " << files_[3].first << " "
       << files_[3].second << "\n";
  list << files_[2].first << " " << files_[2].second << " " << files_[1].first << "\n";
  list.close();
  const ProgramResult result =
      RunSilt("align --pairs " + Path("pairs.txt") + kCamera + " --json -");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json pairs = Json::parse(result.out)["pairs"];
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0]["status"], "tracked");
  EXPECT_LT(Distance(PoseOf(pairs[0]["current_from_reference"]), Truth(0, 3)), 1e-3);
  EXPECT_LT(Distance(PoseOf(pairs[1]["current_from_reference"]), Truth(2, 1)), 3e-3);
  EXPECT_GT(pairs[0]["inverse_depth_residual"], 0);
  EXPECT_EQ(pairs[1]["inverse_depth_residual"], 0);
  const std::vector<double> covariance = pairs[0]["covariance"];
  ASSERT_EQ(covariance.size(), 36u);
  EXPECT_GT(covariance[21], 0);
  EXPECT_LT(covariance[21], 1e-6);
  EXPECT_EQ(covariance[1], covariance[6]);
}

TEST_F(AlignCommand, PrintsMatrixTumLineAndStatus) {
  const ProgramResult result = RunSilt("align" + Ref(0) + " --cur " + Path(files_[1].first) + " " +
                                       Path(files_[1].second) + kCamera + " --preset fast");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr(" 1.000000000\n"));
  EXPECT_THAT(result.out, HasSubstr("\nt tx ty tz qx qy qz qw: "));
  EXPECT_THAT(result.out, HasSubstr("\ncovariance of (omega, v), rad and m:\n"));
  EXPECT_THAT(result.out, HasSubstr("standard deviations "));
  EXPECT_THAT(result.out, HasSubstr("tracked, residual 0.0"));
}

// The colours of a camera of another focal length, beside depths that stay.
void Zoom(const std::string& from, const std::string& to) {
  const Image<Rgb8> whole = ReadRgb(from);
  Image<Rgb8> zoomed(whole.width(), whole.height());
  const int cx = whole.width() / 2, cy = whole.height() / 2;
  for (int y = 0; y < whole.height(); ++y) {
    for (int x = 0; x < whole.width(); ++x) {
      zoomed(x, y) = whole(cx + (x - cx) * 9 / 10, cy + (y - cy) * 9 / 10);
    }
  }
  WriteRgb(to, zoomed);
}

TEST_F(AlignCommand, TellsOfColoursThatAreNotRegistered) {
  const std::string command = "align" + Ref(0) + " --cur " + Path(files_[1].first) + " " +
                              Path(files_[1].second) + kCamera + " --preset fast";
  EXPECT_GT(Pair(command)["edge_contrast"], 1.4);
  EXPECT_THAT(RunSilt(command).out, Not(HasSubstr("colours do not lie on their depths")));
  Zoom(Path(files_[0].first), Path("zoomed0.png"));
  Zoom(Path(files_[1].first), Path("zoomed1.png"));
  const std::string zoomed = "align --ref " + Path("zoomed0.png") + " " + Path(files_[0].second) +
                             " --cur " + Path("zoomed1.png") + " " + Path(files_[1].second) +
                             kCamera + " --preset ";
  EXPECT_LT(Pair(zoomed + "fast")["edge_contrast"], 1.4);
  EXPECT_THAT(RunSilt(zoomed + "fast").out, HasSubstr("colours do not lie on their depths"));
  // Which has nothing but colours.
  EXPECT_THAT(RunSilt(zoomed + "paper").out, Not(HasSubstr("colours do not lie")));
}

// The same pictures, said to be of a camera whose y axis points up: only the words for the pose
// change.
TEST_F(AlignCommand, ANegativeFyMirrorsThePose) {
  const std::string pair =
      "align" + Ref(0) + " --cur " + Path(files_[2].first) + " " + Path(files_[2].second);
  const auto pose = [&](const std::string& camera) {
    return PoseOf(Pair(pair + camera)["current_from_reference"]);
  };
  const SE3d mirrored = pose(" --camera 240.6 -240 159.5 119.5");
  EXPECT_LT(Distance(mirrored, Mirrored(Truth(0, 2))), 1e-3);
  EXPECT_GT(Distance(mirrored, Truth(0, 2)), 1e-2);
}

// F·T·F with F = diag(1, −1, 1).
TEST(Mirrored, TurnsTheYAxes) {
  const SE3d pose = SE3d::Exp({{0.2, -0.3, 0.4}, {1, 2, 3}});
  const auto flip = [](const Vec3d& p) { return Vec3d{p.x, -p.y, p.z}; };
  const Vec3d point{0.3, -0.7, 1.9};
  const Vec3d expected = flip(pose * flip(point)), actual = Mirrored(pose) * point;
  EXPECT_LT(Norm(expected - actual), 1e-12);
  EXPECT_LT(Distance(Mirrored(Mirrored(pose)), pose), 1e-12);
}

TEST_F(AlignCommand, SaysSoWhenLost) {
  Image<Rgb8> gray(320, 240);
  WriteRgb(*folder_ / "s/gray.png", gray);
  const ProgramResult result =
      RunSilt("align" + Ref(0) + " --cur " + Path("gray.png") + kCamera + " --json -");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json pair = Json::parse(result.out)["pairs"][0];
  EXPECT_EQ(pair["status"], "lost");
  EXPECT_THAT(pair["message"].get<std::string>(), HasSubstr("lost: "));
  for (const char* name : {"current_from_reference", "tum", "covariance"}) {
    EXPECT_TRUE(pair.at(name).is_null()) << name;
  }
  const std::string lines = RunSilt("align" + Ref(0) + " --cur " + Path("gray.png") + kCamera).out;
  EXPECT_THAT(lines, StartsWith("lost: "));
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1);
}

// Six rows of six, the numbers of the JSON to the digits that are printed.
TEST_F(AlignCommand, PrintsTheCovariance) {
  const std::string pair = "align" + Ref(0) + " --cur " + Path(files_[1].first) + kCamera;
  const std::vector<double> wanted = Pair(pair)["covariance"];
  std::istringstream lines(RunSilt(pair).out);
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("covariance")) {
  }
  for (const double value : wanted) {
    double printed = 0;
    ASSERT_TRUE(lines >> printed);
    EXPECT_NEAR(printed, value, 0.006 * std::abs(value));
  }
}

// The time is that of the current image's name.
TEST_F(AlignCommand, WritesATumLine) {
  fs::copy(Path(files_[1].first), *folder_ / "s/1.25.png");
  fs::copy(Path(files_[1].first), *folder_ / "s/one.png");
  for (const auto& [name, time_s] : {std::pair{"1.25.png", 1.25}, std::pair{"one.png", 0.0}}) {
    const Json pair = Pair("align" + Ref(0) + " --cur " + Path(name) + kCamera);
    std::istringstream line(pair["tum"].get<std::string>());
    const Trajectory read = ParseTumTrajectory(line, name);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].time_s, time_s);
    EXPECT_LT(Distance(read[0].world_from_camera, PoseOf(pair["current_from_reference"])), 1e-8);
  }
}

// With one solve at one level there is no way to the truth but from beside it.
TEST_F(AlignCommand, StartsFromTheInitialPose) {
  const std::string pair = "align" + Ref(0) + " --cur " + Path(files_[3].first) + " " +
                           Path(files_[3].second) + " --preset paper:max_iterations=1 ";
  const auto error = [&](const std::string& camera, const SE3d& initial, const SE3d& wanted) {
    const auto& [q, t] = initial;
    std::ostringstream numbers;
    numbers << " --initial " << t.x << " " << t.y << " " << t.z << " " << q.x << " " << q.y << " "
            << q.z << " " << q.w;
    const Json found = Pair(pair + camera + numbers.str())["current_from_reference"];
    return found.is_null() ? 1.0 : Distance(PoseOf(found), wanted);
  };
  const SE3d truth = Truth(0, 3);
  ASSERT_GT(Distance(truth, Mirrored(truth)), 0.02);
  EXPECT_LT(error(kCamera, truth, truth), 2e-3);
  EXPECT_GT(error(kCamera, SE3d{}, truth), 1e-2);
  const std::string mirror = " --camera 240.6 -240 159.5 119.5";
  EXPECT_LT(error(mirror, Mirrored(truth), Mirrored(truth)), 2e-3);
  EXPECT_GT(error(mirror, truth, Mirrored(truth)), 1e-2);
}

TEST_F(AlignCommand, TheManifestHoldsTheStart) {
  const std::string pair = "align" + Ref(0) + " --cur " + Path(files_[1].first) + kCamera;
  const auto config = [&](const std::string& options) {
    return Json::parse(RunSilt(pair + options + " --json -").out)["manifest"]["config"];
  };
  EXPECT_TRUE(config("")["initial"].is_null());
  const Json given = config(" --init rotation --initial 0 0 0.5 0 0 0 1");
  EXPECT_EQ(given["initial"], (std::vector<double>{0, 0, 0.5, 0, 0, 0, 1}));
  EXPECT_EQ(given["tracker"]["initializer"], "rotation");
}

// Of a pair that is too far apart for the start that it has else.
TEST_F(AlignCommand, StartsAsItIsTold) {
  const std::string pair = "align" + Ref(0) + " --cur " + Path(files_[3].first) + " " +
                           Path(files_[3].second) + kCamera +
                           " --preset paper:max_iterations=1 --init ";
  const auto error = [&](const std::string& kind) {
    const Json found = Pair(pair + kind)["current_from_reference"];
    return found.is_null() ? 1.0 : Distance(PoseOf(found), Truth(0, 3));
  };
  const double still = error("identity");
  for (const char* kind : {"orb", "auto"}) EXPECT_LT(error(kind), 0.5 * still) << kind;
  EXPECT_GT(std::abs(error("rotation") - still), 1e-3);  // a turn alone is not the motion
}

// The same depths in steps of a millimetre, and gray images of 16 bits.
TEST_F(AlignCommand, ReadsOtherDepthScalesAndSixteenBits) {
  const auto rewrite = [&](std::size_t i, const std::string& name) {
    const Image<Rgb8> rgb = ReadRgb(Path(files_[i].first));
    Image<std::uint16_t> gray(rgb.width(), rgb.height());
    for (std::size_t k = 0; k < gray.size(); ++k) gray.data()[k] = 257 * rgb.data()[k].g;
    WriteGray(Path(name + ".png"), gray);
    WriteDepth(Path(name + "-depth.png"), ReadDepth(Path(files_[i].second)), 1000);
    return Path(name + ".png") + " " + Path(name + "-depth.png");
  };
  const Json pair = Pair("align --ref " + rewrite(0, "ref") + " --cur " + rewrite(3, "cur") +
                         kCamera + " --depth-scale 1000");
  EXPECT_EQ(pair["status"], "tracked");
  EXPECT_LT(Distance(PoseOf(pair["current_from_reference"]), Truth(0, 3)), 2e-3);
}

TEST_F(AlignCommand, BadInputIsToldInOneLine) {
  const auto error = [&](const std::string& arguments) {
    SCOPED_TRACE(arguments);
    const ProgramResult result = RunSilt("align " + arguments);
    ExpectOneLineError(result);
    return result.error;
  };
  const std::string cur = " --cur " + Path(files_[1].first);
  EXPECT_THAT(error(kCamera), HasSubstr("either --ref and --cur, or --pairs"));
  EXPECT_THAT(error(Ref(0) + cur), HasSubstr("--camera"));
  EXPECT_THAT(error(Ref(0) + cur + " --camera 0 240 160 120"), HasSubstr("--camera: fx"));
  EXPECT_THAT(error(Ref(0) + cur + kCamera + " --depth-scale 0"), HasSubstr("--depth-scale"));
  EXPECT_THAT(error(Ref(0) + cur + kCamera + " --initial 0 0 0 0 0 0 0"), HasSubstr("--initial"));
  EXPECT_THAT(error(Ref(0) + cur + kCamera + " --init truth"), HasSubstr("--init 'truth'"));
  EXPECT_THAT(error(Ref(0) + cur + kCamera + " --init previous"), HasSubstr("there are: auto,"));
  EXPECT_THAT(error(Ref(0) + cur + kCamera + " --init orb --initial 0 0 0 0 0 0 1"),
              HasSubstr("--initial: --init orb"));
  EXPECT_THAT(error(Ref(0) + " --cur /none.png" + kCamera), HasSubstr("/none.png"));
  EXPECT_THAT(error("--pairs /none.txt" + kCamera), HasSubstr("/none.txt"));
  std::ofstream(*folder_ / "s/bad.txt") << "\n" << files_[0].first << " gone.png gone.png\n";
  EXPECT_THAT(error("--pairs " + Path("bad.txt") + kCamera), HasSubstr("bad.txt:2: no file 'gone"));
  std::ofstream(*folder_ / "s/short.txt") << "a b\n";
  EXPECT_THAT(error("--pairs " + Path("short.txt") + kCamera), HasSubstr("short.txt:1: 2 names"));
  Image<Rgb8> small(32, 24);
  WriteRgb(*folder_ / "s/small.png", small);
  EXPECT_THAT(error(Ref(0) + " --cur " + Path("small.png") + kCamera),
              HasSubstr("small.png: 32x24 pixels where 320x240"));
}

}  // namespace
}  // namespace silt::experiments
