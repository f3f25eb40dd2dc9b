// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "key_poses.h"
#include "silt/core/error.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kTwoKeys = R"(# line 1
[[key]]
time_s = 0
position = [1, 2, 1.5]
look_at = [1, 4, 1.5]
[[key]]                    # line 6
time_s = 2.5
position = [1.5, 2, 1.5]
quaternion = [0, 0, 0, -1]
)";

// The message must be one line that starts with file and line.
void ExpectError(const std::string& text, int line, const std::string& what) {
  SCOPED_TRACE(text);
  try {
    ParseCameraPath(text, "path.toml");
    ADD_FAILURE() << "was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), StartsWith("path.toml:" + std::to_string(line) + ": "));
    EXPECT_THAT(error.what(), HasSubstr(what));
    EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
  }
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(PathFile, PassesThroughItsKeys) {
  const CameraPath path = ParseCameraPath(kTwoKeys, "path.toml");
  EXPECT_EQ(path.duration_s(), 2.5);
  EXPECT_LT(PoseDistance(path.WorldFromCamera(0), LookAt({1, 2, 1.5}, {1, 4, 1.5})), 1e-9);
  EXPECT_LT(PoseDistance(path.WorldFromCamera(2.5), {{}, {1.5, 2, 1.5}}), 1e-9);
}

TEST(PathFile, QuaternionsAreInTheOrderOfTumFiles) {
  const CameraPath path =
      ParseCameraPath(Replaced(kTwoKeys, "[0, 0, 0, -1]", "[-0.6, 0, 0, 0.8]"), "path.toml");
  const Quaterniond q = path.WorldFromCamera(2.5).rotation;
  EXPECT_LT(RotationAngle(q.Conjugate() * Quaterniond{0.8, -0.6, 0, 0}), 1e-9);
}

// Leaning to the right, the camera's right side goes down: world up moves to the image's left.
TEST(PathFile, PositiveRollLeansToTheRight) {
  const std::string text = Replaced(kTwoKeys, "look_at", "roll_deg = 90\nlook_at");
  const SE3d pose = ParseCameraPath(text, "path.toml").WorldFromCamera(0);
  EXPECT_LT(Norm(pose.rotation * Vec3d{1, 0, 0} - Vec3d{0, 0, -1}), 1e-9);
  EXPECT_LT(Norm(pose.rotation * Vec3d{0, 0, 1} - Vec3d{0, 1, 0}), 1e-9);
}

TEST(PathFile, HandShakeIsAdded) {
  const std::string shake =
      "[hand_shake]\nposition_mm = 2\nrotation_deg = 0.5\nband_hz = [1, 4]\nseed = 9\n";
  const CameraPath path = ParseCameraPath(kTwoKeys + shake, "path.toml");
  const CameraPath expected(
      path.spline(),
      HandShake({.position_mm = 2, .rotation_deg = 0.5, .low_hz = 1, .high_hz = 4, .seed = 9}));
  for (const double t : {0.0, 0.7, 2.5}) {
    EXPECT_LT(PoseDistance(path.WorldFromCamera(t), expected.WorldFromCamera(t)), 1e-15);
    EXPECT_GT(PoseDistance(path.WorldFromCamera(t), path.spline().At(t)), 1e-4);
  }
}

TEST(PathFile, BrokenKeysAreErrorsWithTheirLine) {
  const auto broken = [](const std::string& from, const std::string& to) {
    return Replaced(kTwoKeys, from, to);
  };
  ExpectError(broken("time_s = 0", "time_s = 0.5"), 3, "must be 0");
  ExpectError(broken("time_s = 2.5", "time_s = 0"), 7, "after that of the key before");
  ExpectError(broken("time_s = 2.5", "time_s = inf"), 7, "finite");
  ExpectError(broken("time_s = 2.5", "time_s = 1e9"), 7, "100000");
  ExpectError(broken("time_s = 2.5", ""), 6, "time_s is missing");
  ExpectError(broken("[1, 2, 1.5]", "[1, 2]"), 4, "3 finite numbers");
  ExpectError(broken("[1, 2, 1.5]", "[1, nan, 1.5]"), 4, "3 finite numbers");
  ExpectError(broken("position = [1, 2, 1.5]", ""), 2, "position is missing");
  ExpectError(broken("look_at = [1, 4, 1.5]", ""), 2, "look_at is missing");
  ExpectError(broken("look_at = [1, 4, 1.5]", "look_at = [1, 2, 1.5]"), 5, "position itself");
  ExpectError(broken("look_at = [1, 4, 1.5]", "look_at = [1, 2, 0]"), 5, "straight above");
  ExpectError(broken("[0, 0, 0, -1]", "[0, 0, 0, 2]"), 9, "norm 1");
  ExpectError(broken("[0, 0, 0, -1]", "[0, 0, 0, 0]"), 9, "norm 1");
  ExpectError(broken("look_at", "quaternion = [0, 0, 0, 1]\nlook_at"), 5, "exclude");
  ExpectError(broken("look_at", "lookat"), 2, "look_at is missing");
  ExpectError(broken("quaternion", "roll_deg = 1\nquaternion"), 9, "unknown key 'roll_deg'");
  ExpectError(broken("[0, 0, 0, -1]", "[0, 1, 0, 0]"), 6, "turns by 180 degrees");
}

TEST(PathFile, BrokenFilesAreErrorsWithTheirLine) {
  ExpectError("", 1, "two [[key]]");
  ExpectError(kTwoKeys.substr(0, kTwoKeys.find("[[key]]                    # line 6")), 2,
              "two [[key]]");
  ExpectError("key = 3\n", 1, "[[key]]");
  ExpectError(kTwoKeys + "[[keys]]\n", 10, "unknown key 'keys'");
  ExpectError(kTwoKeys + "oops\n", 10, "TOML");
  ExpectError(kTwoKeys + "[hand_shake]\nposition_mm = -1\n", 10, "position_mm");
  ExpectError(kTwoKeys + "[hand_shake]\nmm = 1\n", 11, "unknown key 'mm'");
  ExpectError(kTwoKeys + "[hand_shake]\nseed = -1\n", 11, "negative");
  ExpectError(kTwoKeys + "[hand_shake]\nband_hz = [1, 1]\n", 10, "low_hz");
  ExpectError("hand_shake = 1\n" + kTwoKeys, 1, "[hand_shake]");
}

// The path on which the paper's accuracy is measured, and a second one through the same room.
TEST(PathFile, TheOfficesPathsMoveLikeAHandHeldCamera) {
  const std::filesystem::path office = SILT_SOURCE_DIR "/scenes/office";
  const PathStatistics desk = LoadCameraPath(office / "desk.toml").Statistics();
  EXPECT_NEAR(desk.duration_s, 30, 0.5);
  EXPECT_NEAR(desk.length_m, 6.93, 0.02);
  EXPECT_NEAR(desk.mean_speed_m_s, 0.23, 0.01);
  for (const char* name : {"desk.toml", "tour.toml"}) {
    SCOPED_TRACE(name);
    const PathStatistics path = LoadCameraPath(office / name).Statistics();
    EXPECT_NEAR(path.mean_turn_deg_s, 15, 2);
    EXPECT_LT(path.max_speed_m_s, 0.6);
    EXPECT_LT(path.max_turn_deg_s, 60);
    EXPECT_GT(path.lowest.z, 0.5);
    EXPECT_LT(path.highest.z, 2.2);
  }
}

TEST(PathFile, ThatCannotBeReadIsAnError) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "silt_path_file_test";
  std::filesystem::create_directories(folder);
  EXPECT_THROW(LoadCameraPath(folder), Error);
  EXPECT_THROW(LoadCameraPath(folder / "missing.toml"), Error);
  std::ofstream(folder / "path.toml") << kTwoKeys;
  EXPECT_EQ(LoadCameraPath(folder / "path.toml").duration_s(), 2.5);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace silt::sim
