// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "silt_program.h"

// The experiments from the command line, as small as they get.
namespace silt::experiments {
namespace {

using testing::HasSubstr;

nlohmann::json ResultsOf(const TestFolder& folder, const std::string& experiment,
                         const std::string& options) {
  const auto out = folder / experiment;
  const ProgramResult result =
      RunSilt("experiment " + experiment + " --scene studio " + options + " --out " + out.string());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("Results: "));
  EXPECT_TRUE(std::filesystem::exists(out / "manifest.json"));
  const auto json = nlohmann::json::parse(ReadText(out / (experiment + ".json")), nullptr, false);
  EXPECT_EQ(json["manifest"]["program"], "silt");
  EXPECT_THAT(json["manifest"]["command"].get<std::string>(),
              HasSubstr("experiment " + experiment));
  return json;
}

TEST(ConvergenceCommand, WritesTable1AndSuccessRates) {
  const TestFolder folder;
  const auto json = ResultsOf(folder, "convergence", "--quick --width 160 --starts 1");
  EXPECT_EQ(json["recovery"].size(), 32u);  // of three presets, two of which start wide
  EXPECT_EQ(json["recovery_pairs"].size(), 2u);
  EXPECT_EQ(json["odometry_trials"].size(), 6u);
  EXPECT_EQ(json["odometry_trials"][1]["current"], "rendered");
  EXPECT_THAT(ReadText(folder / "convergence/recovery.csv"), HasSubstr("at 20 cm and 10 deg"));
  EXPECT_EQ(json["levels"].size(), 5u);
  EXPECT_EQ(json["success_rates"].size(), 6u);
  EXPECT_THAT(ReadText(folder / "convergence/levels.csv"), HasSubstr("paper_ratio"));
  EXPECT_THAT(ReadText(folder / "convergence/iterations.csv"), HasSubstr("update_norm"));
}

TEST(InitializationCommand, WritesACasePerConditionKeyframeGapAndMethod) {
  const TestFolder folder;
  const auto json =
      ResultsOf(folder, "initialization", "--quick --width 160 --spp 1 --keyframes 1 --gaps 1 5");
  EXPECT_EQ(json["cases"].size(), 54u);
  EXPECT_EQ(json["summary"].size(), 54u);
  EXPECT_EQ(json["summary"][0]["condition"], "sharp");
  EXPECT_EQ(json["summary"][53]["condition"], "blurred");
  EXPECT_THAT(ReadText(folder / "initialization/summary.csv"), HasSubstr("noisy,5,surf,1,"));
}

TEST(LightCommand, ComparesBakedWithTracedLight) {
  const TestFolder folder;
  const auto json = ResultsOf(folder, "light", "--quick");
  ASSERT_EQ(json["differences"].size(), 3u);
  const auto& all = json["differences"][2];
  EXPECT_EQ(all["view"], "all");
  EXPECT_LT(std::abs(all["bias"].get<double>()), 1.5);
  EXPECT_LT(all["rms_without_noise"].get<double>(), 4);
  EXPECT_GT(all["reference_noise"].get<double>(), 0);
  EXPECT_GT(json["rms_of_two_bakes"].get<double>(), 0);
  EXPECT_LT(json["rms_of_two_bakes"].get<double>(), 0.5);
  EXPECT_THAT(ReadText(folder / "light/differences.csv"), HasSubstr("orbit_1,"));
  for (const char* kind : {"baked", "traced", "difference"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("light/orbit_0_" + std::string(kind) + ".png")));
  }
}

TEST(TimingCommand, WritesStagesAndLeavesNoFramesBehind) {
  const TestFolder folder;
  const auto json = ResultsOf(folder, "timing", "--quick --width 160 --duration 0.2");
  EXPECT_EQ(json["frames"].size(), 4u);
  EXPECT_EQ(json["stages"][0]["stage"], "load");
  EXPECT_FALSE(std::filesystem::exists(folder / "timing/frames"));
}

struct BadExperiment {
  std::string arguments, said;
};

void PrintTo(const BadExperiment& bad, std::ostream* out) { *out << bad.arguments; }

class BadExperiments : public testing::TestWithParam<BadExperiment> {};

TEST_P(BadExperiments, FailInOneLineAndLeaveNothing) {
  const TestFolder folder;
  const ProgramResult result =
      RunSilt("experiment " + GetParam().arguments + " --out " + (folder / "results").string());
  ExpectOneLineError(result, GetParam().said);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

INSTANTIATE_TEST_SUITE_P(
    Of, BadExperiments,
    testing::Values(BadExperiment{"convergence --scene nowhere", "nowhere"},
                    BadExperiment{"convergence --scene studio --starts 0", "--starts: '0'"},
                    BadExperiment{"convergence --scene studio --backend abacus", "abacus"},
                    BadExperiment{"convergence --scene studio --image 900", "has no frame at"},
                    BadExperiment{"initialization --scene studio --gaps 1 x", "--gaps: 'x'"},
                    BadExperiment{"initialization --scene studio --gaps 9000", "too short"},
                    BadExperiment{"timing --scene studio --duration 1000", "ask for more"},
                    BadExperiment{"timing --scene studio --width 64 --duration 0.05", "two frames"},
                    BadExperiment{"timing --scene studio --fps 0", "--fps: '0'"}));

TEST(TrustCommand, WritesFactorsAndEverySample) {
  const TestFolder folder;
  const auto json = ResultsOf(folder, "trust", "--width 160 --pairs 2 --preset fast");
  EXPECT_EQ(json["summary"].size(), 3u);
  EXPECT_EQ(json["samples"].size(), 12u);
  EXPECT_TRUE(json["summary"][0].contains("covariance_factor"));
  EXPECT_THAT(ReadText(folder / "trust/samples.csv"), HasSubstr("uncertainty_rad"));
  EXPECT_THAT(ReadText(folder / "trust/summary.csv"), HasSubstr("within_band"));
}

}  // namespace
}  // namespace silt::experiments
