// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.error, StartsWith("silt: "));
  ExpectOneLineError(result, GetParam().said);
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

// --out of these must never come to be made.
INSTANTIATE_TEST_SUITE_P(
    Render, BadCommandLine,
    testing::Values(
        BadLine{"render --out /none/x", "--scene"}, BadLine{"render --scene studio", "--out"},
        BadLine{"render --scene palace --out build-x", "'palace'; there are:"},
        BadLine{"render --scene ./none.toml --out build-x", "./none.toml"},
        BadLine{"render --scene studio --trajectory moon --out build-x", "'moon'"},
        BadLine{"render --scene studio --fps 0 --out build-x", "--fps: '0'"},
        BadLine{"render --scene studio --fps many --out build-x", "--fps: 'many'"},
        BadLine{"render --scene studio --start -1 --out build-x", "--start"},
        BadLine{"render --scene studio --start 1e5 --out build-x", "--start and --duration"},
        BadLine{"render --scene studio --duration 1e5 --out build-x", "--start and --duration"},
        BadLine{"render --scene studio --spp 0 --out build-x", "--spp"},
        BadLine{"render --scene studio --spp 2.5 --out build-x", "--spp"},
        BadLine{"render --scene studio --width 30 --out build-x", "--width"},
        BadLine{"render --scene studio --blur lots --out build-x", "--blur: 'lots'"},
        BadLine{"render --scene studio --blur 1 --out build-x", "--blur: '1'"},
        BadLine{"render --scene studio --blur 101% --out build-x", "--blur: '101%'"},
        BadLine{"render --scene studio --exposure-time 8kg --out build-x", "--blur: '8kg'"},
        BadLine{"render --scene studio --exposure-time 17ms --out build-x", "--blur: '17ms'"},
        BadLine{"render --scene studio --row-time 40 --out build-x", "--row-time: 480 rows"},
        BadLine{"render --scene studio --row-time -1 --out build-x", "--row-time"},
        BadLine{"render --scene studio --filter cone --out build-x", "--filter"},
        BadLine{"render --scene studio --pattern random --out build-x", "--pattern"},
        BadLine{"render --scene studio --noise white --out build-x", "--noise"},
        BadLine{"render --scene studio --photons 0 --noise emva --out build-x", "--photons: '0'"},
        BadLine{"render --scene studio --photons 9 --out build-x", "add --noise emva"},
        BadLine{"render --scene studio --response rec709 --out build-x", "'rec709' is no file"},
        BadLine{"render --scene studio --response gamma:x --out build-x", "gamma:2.2"},
        BadLine{"render --scene studio --vignetting cos3 --out build-x", "--vignetting: 'cos3'"},
        BadLine{"render --scene studio --vignetting 1,2 --out build-x", "--vignetting: '1,2'"},
        BadLine{"render --scene studio --vignetting=-2,0,0 --out build-x", "vignetting: the share"},
        BadLine{"render --scene studio --lens 1 2 3 4 --out build-x", "--lens"},
        BadLine{"render --scene studio --lens 1 2 3 4 x --out build-x", "--lens"},
        BadLine{"render --scene studio --lens -2 0 0 0 0 --out build-x", "fold the picture"},
        BadLine{"render --scene studio --depth-sensor lidar --out build-x", "--depth-sensor"},
        BadLine{"render --scene studio --sensor /none.toml --out build-x", "/none.toml"},
        BadLine{"render --scene studio --seed -1 --out build-x", "--seed"},
        BadLine{"render --scene studio --threads -1 --out build-x", "--threads"},
        BadLine{"render --scene studio --out /usr", "silt did not write"},
        BadLine{"render --scene studio --duration 0.1 --out /proc/none/x", "/proc/none/x"}));

INSTANTIATE_TEST_SUITE_P(
    Track, BadCommandLine,
    testing::Values(BadLine{"track --out x.txt", "--scene"},
                    BadLine{"track /none --scene studio --out x.txt", "either"},
                    BadLine{"track /none --out x.txt", "/none"}, BadLine{"track /none", "--out"},
                    BadLine{"track /none --fps-skip 0 --out x.txt", "--fps-skip"},
                    BadLine{"track /tmp --camera 1 2 3 --out x.txt", "--camera"},
                    BadLine{"track /tmp --camera 1 0 3 4 --out x.txt",
                            "fx must be above 0 and fy not 0"},
                    BadLine{"track --scene studio --camera 1 2 3 4 --out x.txt", "its own"},
                    BadLine{"track --scene studio --preset best --out x.txt", "'best'"},
                    BadLine{"track --scene studio --lens -2 0 0 0 0 --out x.txt", "fold"},
                    BadLine{"track --scene studio --backend gpu --out x.txt", "'gpu'"},
                    BadLine{"track --scene studio --graph=never --out x.txt", "never"},
                    BadLine{"track --scene studio --init magic --out x.txt", "'magic'"}));

INSTANTIATE_TEST_SUITE_P(
    Experiment, BadCommandLine,
    testing::Values(BadLine{"experiment", "subcommand"}, BadLine{"experiment speed", "speed"},
                    BadLine{"experiment accuracy", "--out"},
                    BadLine{"experiment accuracy --full --quick --out x", "not both"},
                    BadLine{"experiment accuracy --seeds 0 --out x", "--seeds"},
                    BadLine{"experiment accuracy --duration 0 --out x", "--duration"},
                    BadLine{"experiment accuracy --width 1 --out x", "--width"},
                    BadLine{"experiment accuracy --quick --preset best --out x", "'best'"},
                    BadLine{"experiment accuracy --quick --backend gpu --out x", "'gpu'"},
                    BadLine{"experiment accuracy --out /usr", "silt did not write"},
                    BadLine{"experiment photo-consistency --pairs 0", "--pairs"},
                    BadLine{"experiment photo-consistency --scene studio --apart 1000 --fps 1",
                            "shorter than a pair"}));

INSTANTIATE_TEST_SUITE_P(Bench, BadCommandLine,
                         testing::Values(BadLine{"bench", "subcommand"},
                                         BadLine{"bench tracker", "tracker"},
                                         BadLine{"bench render --scene palace", "'palace'"},
                                         BadLine{"bench render --repeats 0", "--repeats"}));

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
  for (const char* fact :
       {"commit", "compiler", "threads", "cuda", "simd", "Embree", "OpenCV", "Eigen", "studio"}) {
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
