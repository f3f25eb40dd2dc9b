// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/trajectory.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct BadLine {
  std::string arguments, said;
};

void PrintTo(const BadLine& line, std::ostream* out) { *out << line.arguments; }

class BadCommandLine : public testing::TestWithParam<BadLine> {};

TEST_P(BadCommandLine, IsToldInOneLine) {
  const ProgramResult result = RunSilt(GetParam().arguments);
  EXPECT_GT(result.exit_code, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.error, StartsWith("silt: "));
  EXPECT_THAT(result.error, HasSubstr(GetParam().said));
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  EXPECT_LT(result.error.size(), 300u);
}

INSTANTIATE_TEST_SUITE_P(Program, BadCommandLine,
                         testing::Values(BadLine{"", "command"}, BadLine{"rendr", "rendr"},
                                         BadLine{"--bogus", "--bogus"},
                                         BadLine{"info --bogus", "--bogus"},
                                         BadLine{"info extra", "extra"}));

INSTANTIATE_TEST_SUITE_P(Evaluate, BadCommandLine,
                         testing::Values(BadLine{"evaluate", "truth"},
                                         BadLine{"evaluate a", "estimate"},
                                         BadLine{"evaluate /none/a /none/b", "/none/a"},
                                         BadLine{"evaluate / /", "cannot be read"},
                                         BadLine{"evaluate a b --convention kitti", "--convention"},
                                         BadLine{"evaluate a b --seconds x", "--seconds: 'x'"},
                                         BadLine{"evaluate a b --seconds 0", "--seconds: '0'"},
                                         BadLine{"evaluate a b --seconds nan", "--seconds: 'nan'"},
                                         BadLine{"evaluate a b --metres -1", "--metres"},
                                         BadLine{"evaluate a b --frames 1e99", "--frames"}));

class EvaluateCommand : public testing::Test {
 protected:
  void SetUp() override {
    Trajectory truth;
    for (int i = 0; i < 30; ++i)
      truth.push_back({0.1 * i, SE3d::Exp({{0, 0.1 * i, 0}, {i * 0.1}})});
    WriteTumTrajectory(folder_ / "truth.txt", truth);
    // 1 cm off from the second pose on.
    for (int i = 1; i < 30; ++i) truth[i].world_from_camera.translation.z += 0.01;
    WriteTumTrajectory(folder_ / "estimate.txt", truth);
  }

  ProgramResult Evaluate(const std::string& options) const {
    return RunSilt("evaluate " + (folder_ / "truth.txt").string() + " " +
                   (folder_ / "estimate.txt").string() + " " + options);
  }

  TestFolder folder_;
};

TEST_F(EvaluateCommand, PrintsATableAndWritesTheSameAsJson) {
  const ProgramResult result = Evaluate("--json " + (folder_ / "e.json").string());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("30 pairs"));
  const auto json = nlohmann::json::parse(ReadText(folder_ / "e.json"));
  EXPECT_NEAR(json["position_cm"]["max"], 1, 1e-6);
}

TEST_F(EvaluateCommand, JsonToStandardOutputComesAlone) {
  const ProgramResult result = Evaluate("--json - --convention tum");
  EXPECT_EQ(nlohmann::json::parse(result.out)["convention"], "tum");
}

TEST_F(EvaluateCommand, AFullDiskIsToldInOneLine) {
  const ProgramResult printed = Evaluate("> /dev/full");
  EXPECT_EQ(printed.exit_code, 1);
  EXPECT_THAT(printed.error, HasSubstr("standard output"));
}

TEST_F(EvaluateCommand, AnOutputFileThatCannotBeMadeIsTold) {
  const ProgramResult result = Evaluate("--json /proc/none/e.json");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.error, HasSubstr("/proc/none"));
}

TEST_F(EvaluateCommand, AMalformedTrajectoryIsToldWithItsLine) {
  std::filesystem::rename(folder_ / "truth.txt", folder_ / "estimate.txt");
  std::ofstream(folder_ / "truth.txt") << "# fine\n0 0 0 0 0 0 0 1\n0.1 0 0 oops 0 0 0 1\n";
  const ProgramResult result = Evaluate("");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.error, HasSubstr("truth.txt:3: 'oops' is not a number"));
}

TEST(InfoCommand, NamesTheBuild) {
  const ProgramResult result = RunSilt("info");
  EXPECT_EQ(result.exit_code, 0);
  for (const char* fact : {"commit", "compiler", "threads", "cuda", "OpenCV", "Eigen"}) {
    EXPECT_THAT(result.out, HasSubstr(fact));
  }
}

TEST(Help, IsGivenForEachCommandOnStandardOutput) {
  for (const std::string command :
       {"", "render", "track", "evaluate", "experiment accuracy", "info"}) {
    const ProgramResult result = RunSilt(command + " --help");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.error, "");
    EXPECT_THAT(result.out, HasSubstr("Usage: silt " + command));
  }
}

TEST(Version, HoldsTheCommit) {
  EXPECT_THAT(RunSilt("--version").out, testing::MatchesRegex("silt [0-9.]+ \\([a-z0-9-]+\\)\n"));
}

}  // namespace
}  // namespace silt::experiments
