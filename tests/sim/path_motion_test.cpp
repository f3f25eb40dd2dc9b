// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
// The motions of a path file besides keys: replay, orbit, line, lissajous.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "key_poses.h"
#include "silt/sim/path_file.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kPi = std::numbers::pi;

const std::string kOrbit = R"([orbit]
center = [1, 2, 1.5]
radius = 0.8
duration_s = 10
)";
const std::string kLine = R"([line]
from = [0, 0, 1.5]
to = [2, 0, 1.5]
duration_s = 4
)";
const std::string kLissajous = R"([lissajous]
center = [0, 0, 1.5]
amplitude = [0.4, 0.2, 0.1]
frequency_hz = [0.2, 0.3, 0.5]
look_at = [0, 3, 1]
duration_s = 10
)";

// A recording of 5 s that starts at `start_s`: an arc of radius 2, seen along its tangent.
class Replay : public testing::Test {
 protected:
  void SetUp() override {
    Trajectory recorded;
    for (int i = 0; i <= 500; ++i) recorded.push_back({1e6 + 0.01 * i, Recorded(0.01 * i)});
    WriteTumTrajectory(folder_.path() / "recorded.txt", recorded);
  }
  static SE3d Recorded(double time_s) {
    const double a = 0.3 * time_s;
    const Vec3d position{2 * std::cos(a), 2 * std::sin(a), 1.5};
    return LookAt(position, position + Vec3d{-std::sin(a), std::cos(a), -0.3});
  }
  CameraPath Load(const std::string& more) const {
    return LoadCameraPath(folder_.Write("path.toml", Text(more)));
  }
  static std::string Text(const std::string& more) {
    return "[replay]\nfile = \"recorded.txt\"\n" + more;
  }

  TempFolder folder_;
};

void ExpectError(const std::string& text, int line, const std::string& what,
                 const std::string& name = "path.toml") {
  SCOPED_TRACE(text);
  const std::string message = ErrorOf([&] { ParseCameraPath(text, name); });
  EXPECT_THAT(message, StartsWith(name + ":" + std::to_string(line) + ": "));
  EXPECT_THAT(message, HasSubstr(what));
  EXPECT_THAT(message, Not(HasSubstr("\n")));
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(Replay, FollowsTheRecordingFromTimeZero) {
  const CameraPath path = Load("");
  EXPECT_NEAR(path.duration_s(), 5, 1e-6);
  ASSERT_TRUE(path.fit().has_value());
  EXPECT_EQ(path.fit()->poses, 501);
  EXPECT_LT(path.fit()->rms_m, 1e-5);
  for (double t = 0; t < 5; t += 0.3) {
    EXPECT_LT(PoseDistance(path.WorldFromCamera(t), Recorded(t)), 5e-4) << t;
  }
}

TEST_F(Replay, TakesAStretchAtAnotherSpeedAndScale) {
  const CameraPath path = Load("start_s = 1\nduration_s = 2\nspeed = 0.5\nscale = 1.5\n");
  EXPECT_NEAR(path.duration_s(), 4, 1e-3);
  for (double t = 0.5; t < 3.5; t += 0.3) {
    const SE3d expected = Recorded(1 + t / 2);
    EXPECT_LT(Norm(path.WorldFromCamera(t).translation - 1.5 * expected.translation), 5e-4) << t;
  }
}

TEST_F(Replay, StartsWhereItIsPlaced) {
  const CameraPath moved = Load("position = [4, 5, 6]\nyaw_deg = 90\n");
  const CameraPath posed = Load("position = [4, 5, 6]\nquaternion = [0, 0, 0, 1]\n");
  const SE3d first = Recorded(0);
  for (double t = 0.5; t < 5; t += 0.5) {
    const SE3d first_from_now = first.Inverse() * Recorded(t);
    const Quaterniond yaw = Quaterniond::Exp({0, 0, kPi / 2});
    const SE3d moved_first{yaw * first.rotation, {4, 5, 6}};
    EXPECT_LT(PoseDistance(moved.WorldFromCamera(t), moved_first * first_from_now), 5e-4);
    EXPECT_LT(PoseDistance(posed.WorldFromCamera(t), SE3d{{}, {4, 5, 6}} * first_from_now), 5e-4);
  }
  const CameraPath looking = Load("position = [4, 5, 2]\nlook_at = [0, 5, 1]\n");
  EXPECT_LT(PoseDistance(looking.WorldFromCamera(0), LookAt({4, 5, 2}, {0, 5, 1})), 5e-4);
}

TEST_F(Replay, TakesHandShake) {
  const std::string shake = "[hand_shake]\nposition_mm = 2\n";
  const CameraPath steady = Load(""), shaken = Load(shake);
  EXPECT_GT(PoseDistance(steady.WorldFromCamera(2), shaken.WorldFromCamera(2)), 1e-4);
}

TEST_F(Replay, BrokenTablesAreErrorsWithTheirLine) {
  const std::string name = (folder_.path() / "path.toml").string();
  const auto expect = [&](const std::string& more, int line, const std::string& what) {
    ExpectError(Text(more), line, what, name);
  };
  expect("smoothing_s = 0\n", 1, "smoothing_s");
  expect("start_s = 5.5\n", 3, "start_s must be in 0");
  expect("duration_s = 6\n", 3, "duration_s must be in 0");
  expect("duration_s = 0.001\n", 3, "fewer than two poses");
  expect("speed = 0\n", 3, "speed");
  expect("scale = -1\n", 3, "scale");
  expect("max_gap_s = 0.005\n", 1, "max_gap_s");
  expect("yaw_deg = 1\nlook_at = [0, 0, 1]\n", 3, "excludes");
  expect("look_at = [2, 0, 0]\n", 3, "straight above");
  expect("smooth = 1\n", 3, "unknown key 'smooth'");
  ExpectError("[replay]\n", 1, "file is missing", name);
  ExpectError("[replay]\nfile = \"none.txt\"\n", 2, "none.txt", name);
  ExpectError("replay = 3\n", 1, "[replay]", name);
  folder_.Write("recorded.txt", "1 0 0 0 0 0 0 1\n2 0 0\n");
  expect("", 2, "recorded.txt:2");
  folder_.Write("recorded.txt", "1 0 0 0 0 0 0 1\n1.1 0 1e300 0 0 0 0 1\n");
  expect("", 2, "farther than 1000 km");
  folder_.Write("recorded.txt", "1 0 0 0 0 0 0 1\n");
  expect("", 2, "fewer than two poses");
}

TEST(PathMotion, ShapesAreReadWithTheirDefaults) {
  const CameraPath orbit = ParseCameraPath(kOrbit, "path.toml");
  EXPECT_LT(PoseDistance(orbit.WorldFromCamera(5), LookAt({0.2, 2, 1.5}, {1, 2, 1.5})), 1e-5);
  const CameraPath line = ParseCameraPath(kLine, "path.toml");
  EXPECT_LT(PoseDistance(line.WorldFromCamera(1), LookAt({0.5, 0, 1.5}, {2, 0, 1.5})), 1e-9);
  const CameraPath figure = ParseCameraPath(kLissajous, "path.toml");
  EXPECT_LT(PoseDistance(figure.WorldFromCamera(5), LookAt({0, 0, 1.5}, {0, 3, 1})), 1e-5);
  EXPECT_FALSE(orbit.fit().has_value());
}

TEST(PathMotion, ShapesAreReadWithAllTheirKeys) {
  const CameraPath orbit = ParseCameraPath(
      kOrbit + "from_deg = 90\nsweep_deg = -180\nlook_at = [1, 2, 0]\nroll_deg = 90\nease_s = 2\n",
      "path.toml");
  const SE3d half = LookAt({1.8, 2, 1.5}, {1, 2, 0});
  const SE3d rolled{half.rotation * Quaterniond::Exp({0, 0, kPi / 2}), half.translation};
  EXPECT_LT(PoseDistance(orbit.WorldFromCamera(5), rolled), 1e-5);
  EXPECT_LT(Norm(orbit.Motion(0).velocity), 1e-3);
  const CameraPath line = ParseCameraPath(kLine + "direction = [0, 1, 0]\n", "path.toml");
  EXPECT_LT(PoseDistance(line.WorldFromCamera(2), LookAt({1, 0, 1.5}, {1, 1, 1.5})), 1e-9);
  const CameraPath figure = ParseCameraPath(kLissajous + "phase_deg = [90, 0, 0]\n", "path.toml");
  EXPECT_NEAR(figure.WorldFromCamera(5).translation.x, 0.4, 1e-5);
}

TEST(PathMotion, BrokenShapesAreErrorsWithTheirLine) {
  ExpectError(Replaced(kOrbit, "radius = 0.8", "radius = 0"), 1, "radius");
  ExpectError(Replaced(kOrbit, "radius = 0.8", ""), 1, "radius is missing");
  ExpectError(Replaced(kOrbit, "10", "-1"), 1, "duration_s");
  ExpectError(kOrbit + "ease_s = 6\n", 1, "ease_s");
  ExpectError(kOrbit + "look_at = [1, 2, 0]\ndirection = [1, 0, 0]\n", 6, "exclude");
  ExpectError(kOrbit + "speed = 1\n", 5, "unknown key 'speed'");
  ExpectError(Replaced(kLine, "[2, 0, 1.5]", "[0, 0, 1.5]"), 3, "same point");
  ExpectError(Replaced(kLine, "[2, 0, 1.5]", "[0, 0, 2.5]"), 1, "straight up");
  ExpectError(Replaced(kLissajous, "look_at = [0, 3, 1]", ""), 1, "look_at is missing");
  ExpectError(Replaced(kLissajous, "0.5]", "50]"), 1, "frequency_hz");
  ExpectError(Replaced(kLissajous, "0.5]", "nan]"), 4, "finite");
}

TEST(PathMotion, OneMotionAtATime) {
  ExpectError(kOrbit + kLine, 5, "orbit exclude each other");
  ExpectError(kLine + "[[key]]\ntime_s = 0\n", 5, "exclude each other");
}

}  // namespace
}  // namespace silt::sim
