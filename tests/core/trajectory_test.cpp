// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "silt/core/error.h"
#include "silt/core/random.h"

namespace silt {
namespace {

using testing::HasSubstr;
using testing::Not;

Trajectory RandomTrajectory(int size) {
  Trajectory trajectory;
  for (int i = 0; i < size; ++i) {
    const CounterRandom random(11, std::uint64_t(i));
    const Twistd xi{{random.Normal(0), random.Normal(1), random.Normal(2)},
                    {random.Normal(3), random.Normal(4), 100 * random.Normal(5)}};
    trajectory.push_back({1305031102.175304 + i / 60.0, SE3d::Exp(xi)});
  }
  return trajectory;
}

Trajectory Parse(const std::string& text) {
  std::istringstream in(text);
  return ParseTumTrajectory(in, "path.txt");
}

std::string ErrorOf(const std::string& text) {
  try {
    Parse(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(TrajectoryTest, RoundTripKeepsNineDigits) {
  const Trajectory written = RandomTrajectory(200);
  const Trajectory read = Parse(FormatTumTrajectory(written));
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const SE3d& a = written[i].world_from_camera;
    const SE3d& b = read[i].world_from_camera;
    EXPECT_NEAR(read[i].time_s, written[i].time_s, 5e-7);  // what a double of 10 digits holds
    EXPECT_LT(std::abs(a.translation.x - b.translation.x), 5.1e-10);
    EXPECT_LT(std::abs(a.translation.y - b.translation.y), 5.1e-10);
    EXPECT_LT(std::abs(a.translation.z - b.translation.z), 5.1e-10);
    EXPECT_LT(RotationAngle(a.rotation.Conjugate() * b.rotation), 3e-9);
  }
}

TEST(TrajectoryTest, LineHoldsTimeTranslationAndQuaternionWithWLast) {
  const Trajectory trajectory = {{1.5, {{0.5, 0.1, 0.7, 0.5}, {1, 2, -3}}}};
  EXPECT_THAT(FormatTumTrajectory(trajectory),
              HasSubstr("\n1.500000000 1.000000000 2.000000000 -3.000000000 "
                        "0.100000000 0.700000000 0.500000000 0.500000000\n"));
  const SE3d pose = Parse("1.5 1 2 -3 0.1 0.7 0.5 0.5\n")[0].world_from_camera;
  EXPECT_EQ(pose.translation.z, -3);
  EXPECT_EQ(pose.rotation.w, 0.5);
  EXPECT_EQ(pose.rotation.y, 0.7);
}

TEST(TrajectoryTest, CommentsEmptyLinesAndCarriageReturnsPass) {
  const Trajectory trajectory = Parse(
      "# a comment\r\n\n   \t\r\n1 0 0 0 0 0 0 1\r\n # another\n\t2 1 0 0 0 0 0 1  \n"
      "3 1 0 0 0 0 0 1");
  ASSERT_EQ(trajectory.size(), 3u);
  EXPECT_EQ(trajectory[1].time_s, 2);
}

TEST(TrajectoryTest, QuaternionNearNormOneIsNormalized) {
  const Quaterniond q = Parse("1 0 0 0 0 0 0.6025 0.8\n")[0].world_from_camera.rotation;
  EXPECT_NEAR(q.w * q.w + q.z * q.z, 1, 1e-15);
  EXPECT_NEAR(q.z / q.w, 0.6025 / 0.8, 1e-15);
}

struct BadLine {
  const char* text;
  const char* complaint;
};
void PrintTo(const BadLine& bad, std::ostream* out) { *out << bad.text; }

class BadTrajectoryLine : public testing::TestWithParam<BadLine> {};

// The bad line is the fourth of the file, after a comment, an empty line and a good one.
TEST_P(BadTrajectoryLine, IsRefusedWithItsNumber) {
  const std::string error =
      ErrorOf("# time\n\n1 0 0 0 0 0 0 1\n" + std::string(GetParam().text) + "\n9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(error, HasSubstr("path.txt:4: "));
  EXPECT_THAT(error, HasSubstr(GetParam().complaint));
  EXPECT_THAT(error, Not(HasSubstr("\n")));
}

INSTANTIATE_TEST_SUITE_P(Lines, BadTrajectoryLine,
                         testing::Values(BadLine{"2 0 0 0 0 0 0", "expected 8 numbers"},
                                         BadLine{"2", "expected 8 numbers"},
                                         BadLine{"2 0 0 0 0 0 0 1 5", "more than 8 numbers"},
                                         BadLine{"2 0 0 x 0 0 0 1", "'x' is not a number"},
                                         BadLine{"2 0 0 1.5m 0 0 0 1", "'1.5m' is not a number"},
                                         BadLine{"2,0,0,0,0,0,0,1", "is not a number"},
                                         BadLine{"2 nan 0 0 0 0 0 1", "'nan' is not a number"},
                                         BadLine{"2 0 inf 0 0 0 0 1", "'inf' is not a number"},
                                         BadLine{"1e999 0 0 0 0 0 0 1", "'1e999' is not a number"},
                                         BadLine{"2 0 0 0 0 0 0 0", "not of norm 1"},
                                         BadLine{"2 0 0 0 0 0 0 1.02", "not of norm 1"},
                                         BadLine{"1 0 0 0 0 0 0 1", "time does not increase"},
                                         BadLine{"0.5 0 0 0 0 0 0 1", "time does not increase"}));

TEST(TrajectoryTest, GarbageIsQuotedShortAndPrintable) {
  const std::string error = ErrorOf("\x89PNG\x1a\x01\xff" + std::string(5000, 'y') + "\n");
  EXPECT_THAT(error, HasSubstr("path.txt:1: "));
  EXPECT_LT(error.size(), 120u);
  for (char c : error) EXPECT_TRUE(c >= 0x20 && c < 0x7f);
}

TEST(TrajectoryTest, ReadsTheFileItWrote) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "trajectory_test" / "path.txt";
  WriteTumTrajectory(file, RandomTrajectory(5));
  EXPECT_EQ(ReadTumTrajectory(file).size(), 5u);
  std::filesystem::remove_all(file.parent_path());
}

TEST(TrajectoryTest, MissingEmptyAndFolderAreNamed) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "no_path";
  std::filesystem::create_directories(folder);
  const std::filesystem::path empty = folder / "empty.txt";
  std::ofstream(empty) << "# nothing\n";
  for (const auto& file : {folder / "missing.txt", folder, empty}) {
    try {
      ReadTumTrajectory(file);
      ADD_FAILURE() << file;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(file.string() + ": "));
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(TrajectoryTest, PathLengthAddsTheSteps) {
  EXPECT_EQ(PathLength({}), 0);
  const Trajectory corner = {{0, {{}, {0, 0, 0}}}, {1, {{}, {3, 0, 4}}}, {2, {{}, {3, 0, 2}}}};
  EXPECT_DOUBLE_EQ(PathLength(corner), 7);
}

TEST(InterpolatedPose, LiesBetweenItsNeighbours) {
  const SE3d a{Quaterniond::Exp({0, 0, 0.2}), {1, 2, 3}},
      b{Quaterniond::Exp({0, 0, 0.6}), {3, 2, 1}};
  const Trajectory trajectory{{1.0, a}, {1.08, b}, {2.0, a}};
  const std::optional<SE3d> between = InterpolatedPose(trajectory, 1.02, 0.1);
  ASSERT_TRUE(between);
  EXPECT_LT(Norm(between->translation - Vec3d{1.5, 2, 2.5}), 1e-9);
  EXPECT_NEAR(between->rotation.Log().z, 0.3, 1e-9);
  EXPECT_EQ(InterpolatedPose(trajectory, 1.08 + 1e-9, 0.1)->translation.x, 3);
}

TEST(InterpolatedPose, IsNoneBeyondTheEndsAndInWideGaps) {
  const Trajectory trajectory{{1.0, {}}, {1.08, {}}, {2.0, {}}};
  EXPECT_FALSE(InterpolatedPose(trajectory, 0.99, 0.1));
  EXPECT_FALSE(InterpolatedPose(trajectory, 1.5, 0.1));
  EXPECT_FALSE(InterpolatedPose(trajectory, 2.01, 0.1));
  EXPECT_TRUE(InterpolatedPose(trajectory, 1.0, 0.1));
  EXPECT_TRUE(InterpolatedPose(trajectory, 2.0, 0.1));
  EXPECT_FALSE(InterpolatedPose({}, 0, 0.1));
}

}  // namespace
}  // namespace silt
