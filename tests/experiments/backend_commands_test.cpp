// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "silt/core/trajectory.h"
#include "silt/experiments/json.h"
#include "silt/experiments/pose_difference.h"
#include "silt/experiments/tracker_setup.h"
#include "silt_program.h"

// What the command line says of the GPU, with one and without.
namespace silt::experiments {
namespace {

bool HasDevice() { return RunSilt("info").out.find("no device") == std::string::npos; }
bool HasCuda() { return RunSilt("info").out.find("not compiled in") == std::string::npos; }

const std::string kBatch = "bench align-batch --scene studio --pairs 1 --width 64 --starts 3 ";

TEST(BackendCommands, InfoTellsOfCuda) {
  EXPECT_NE(RunSilt("info").out.find("cuda:"), std::string::npos);
}

TEST(BackendCommands, CudaWithoutADeviceIsOneLine) {
  if (HasCuda() && HasDevice()) GTEST_SKIP() << "there is a CUDA device";
  const ProgramResult result = RunSilt(kBatch + "--backend cuda");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "");
  ExpectOneLineError(result, "--backend cuda");
}

TEST(BackendCommands, AutoSaysWhatItTook) {
  const ProgramResult result = RunSilt(kBatch + "--backend auto");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const bool gpu = HasCuda() && HasDevice();
  const std::string told = gpu         ? "--backend auto: cuda\n"
                           : HasCuda() ? "--backend auto: cpu (no CUDA device is at hand)\n"
                                       : "--backend auto: cpu (built without nvcc)\n";
  EXPECT_NE(result.error.find(told), std::string::npos) << result.error;
}

// Not "auto": another machine would compute elsewhere.
TEST(BackendCommands, WhatAutoTookIsWrittenDown) {
  const std::string taken = HasCuda() && HasDevice() ? "cuda" : "cpu";
  const ProgramResult bench = RunSilt(
      "bench track --scene studio --width 64 --gaps 1 --instants 1 --repeats 1 --threads 1 "
      "--preset fast --json - --backend auto");
  ASSERT_EQ(bench.exit_code, 0) << bench.error;
  EXPECT_EQ(Json::parse(bench.out)["manifest"]["config"]["bench"]["backend"], taken);
  const TestFolder folder;
  const std::string out = (folder / "estimate.txt").string();
  const ProgramResult track = RunSilt(
      "track --scene studio --width 64 --spp 1 --fps 10 --duration 0.1 --backend auto --out " +
      out + " --json " + (folder / "track.json").string());
  ASSERT_EQ(track.exit_code, 0) << track.error;
  EXPECT_NE(ReadText(folder / "track.json").find("\"backend\": \"" + taken + "\""),
            std::string::npos);
}

// A backend beside the CPU's.
class BackendCommandsOn : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (std::string(GetParam()) == "cuda" && !(HasCuda() && HasDevice())) {
      GTEST_SKIP() << "no CUDA device, or built without nvcc";
    }
  }
};
INSTANTIATE_TEST_SUITE_P(, BackendCommandsOn, testing::Values("cuda-emulated", "cuda"),
                         [](const testing::TestParamInfo<const char*>& each) {
                           return std::string(each.param) == "cuda" ? "Gpu" : "Emulated";
                         });

TEST_P(BackendCommandsOn, MeasureBatches) {
  for (const std::string backend : {"cpu", GetParam()}) {
    const bool gpu = backend == "cuda";
    const ProgramResult result = RunSilt(kBatch + "--json - --backend " + backend);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["batch"]["alignments"], 3);
    EXPECT_GT(json["batch"]["per_s"], 0);
    EXPECT_GT(json["batch"]["floor_operations"], json["batch"]["floor_bytes"]);
    EXPECT_EQ(json["batch"]["device_ms"].is_null(), !gpu) << "others have no clock of their own";
    EXPECT_EQ(json["batch"]["floor_ms"].is_null(), !gpu) << "of others no ceiling is measured";
    EXPECT_EQ(json["device"]["backend"], backend);
  }
}

// What a command writes for both backends: the CPU's first.
std::vector<Json> OfBoth(const std::string& command, const std::string& other) {
  std::vector<Json> all;
  for (const std::string& backend : {std::string("cpu"), other}) {
    const TestFolder folder;
    const std::string file = (folder / "out/convergence.json").string();
    const bool experiment = command.rfind("experiment", 0) == 0;
    const ProgramResult result =
        RunSilt(command + " --backend " + backend + " --scene studio --width 64 " +
                (experiment ? "--out " + (folder / "out").string() : "--json -"));
    EXPECT_EQ(result.exit_code, 0) << result.error;
    all.push_back(Json::parse(experiment ? ReadText(file) : result.out, nullptr, false));
  }
  return all;
}

TEST_P(BackendCommandsOn, MeasureConvergence) {
  const std::vector<Json> all = OfBoth(
      "experiment convergence --quick --starts 3 --recovery-starts 2 --recovery-pairs 1 "
      "--trials 0 --preset accurate",
      GetParam());
  const Json &cpu = all[0], &other = all[1];
  EXPECT_EQ(cpu["manifest"]["config"]["basics"]["backend"], "cpu");
  EXPECT_EQ(other["manifest"]["config"]["basics"]["backend"], GetParam());
  ASSERT_EQ(cpu["levels"].size(), other["levels"].size());
  for (std::size_t i = 0; i < cpu["levels"].size(); ++i) {
    const double cost = cpu["levels"][i]["initial_cost"];
    EXPECT_NEAR(other["levels"][i]["initial_cost"], cost, 1e-3 * cost);
  }
  int recovered = 0;
  for (const char* rates : {"success_rates", "recovery"}) {
    ASSERT_EQ(cpu[rates].size(), other[rates].size());
    for (std::size_t i = 0; i < cpu[rates].size(); ++i) {
      EXPECT_EQ(cpu[rates][i]["starts"], other[rates][i]["starts"]);
      EXPECT_EQ(cpu[rates][i]["recovered"], other[rates][i]["recovered"]) << rates << i;
      recovered += cpu[rates][i]["recovered"].get<int>();
    }
  }
  EXPECT_GT(recovered, 0);
}

TEST_P(BackendCommandsOn, MeasureTracking) {
  const std::vector<Json> all = OfBoth(
      "bench track --gaps 1 --instants 1 --repeats 1 --threads 1 --preset accurate --preset fast",
      GetParam());
  for (const char* preset : {"accurate", "fast"}) {
    const Json &cpu = all[0]["pairs"][preset], &other = all[1]["pairs"][preset];
    EXPECT_EQ(cpu["lost"], 0);
    EXPECT_EQ(other["lost"], 0);
    EXPECT_GT(other["ms"], 0);
    for (const Json& of_backend : all) {
      const Json& refinement = of_backend["refinement"][preset];
      EXPECT_EQ(refinement["alignments"], 1);
      EXPECT_EQ(refinement["ok"], 1);
      EXPECT_EQ(refinement["device_ms"].is_null(), of_backend["device"]["backend"] != "cuda");
      EXPECT_GT(refinement["bytes_per_s"], 0);
    }
    EXPECT_NEAR(other["t_mm"].get<double>(), cpu["t_mm"].get<double>(), 1e-2) << preset;
  }
  EXPECT_EQ(all[1]["manifest"]["config"]["bench"]["backend"], GetParam());
}

// Many starts at one offset, and no more than that.
TEST(BackendCommands, ConvergenceFromChosenOffsetsAlone) {
  const TestFolder folder;
  const std::string command =
      "experiment convergence --quick --scene studio --width 64 --starts 5 "
      "--pairs 1 --scheme pyramid --recovery-starts 0 --trials 0 --out " +
      (folder / "out").string();
  const ProgramResult result = RunSilt(command + " --offset 4:2 --offset 0:1.5");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json json = Json::parse(ReadText(folder / "out/convergence.json"));
  const Json& rates = json["success_rates"];
  ASSERT_EQ(rates.size(), 2u);
  EXPECT_EQ(rates[0]["scheme"], "four-level pyramid");
  EXPECT_DOUBLE_EQ(rates[0]["distance_m"], 0.04);
  EXPECT_EQ(rates[0]["angle_deg"], 2);
  EXPECT_EQ(rates[0]["starts"], 5);
  EXPECT_EQ(rates[1]["distance_m"], 0);
  EXPECT_TRUE(json["recovery"].empty());
  for (const char* wrong : {"4", "4:", ":2", "4:2x", "-4:2", "4:400"}) {
    const ProgramResult refused = RunSilt(command + " --offset " + wrong);
    EXPECT_EQ(refused.exit_code, 1);
    ExpectOneLineError(refused, "--offset");
  }
}

// Starts that are aligned of what the backend holds.
TEST_P(BackendCommandsOn, FollowTheSameCoarseStarts) {
  const TestFolder folder;
  std::vector<Trajectory> all;
  for (const std::string backend : {"cpu", GetParam()}) {
    const std::string file = (folder / (backend + ".txt")).string();
    const ProgramResult result = RunSilt(
        "track --scene studio --width 160 --spp 1 --fps 10 --duration 0.4 --init rotation "
        "--preset fast --backend " +
        backend + " --out " + file);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    all.push_back(ReadTumTrajectory(file));
  }
  ASSERT_EQ(all[0].size(), 4u);
  ASSERT_EQ(all[1].size(), 4u);
  for (std::size_t i = 0; i < all[0].size(); ++i) {
    const PoseDifference apart =
        Difference(all[0][i].world_from_camera, all[1][i].world_from_camera);
    EXPECT_LT(apart.distance_m, 1e-5) << i;
    EXPECT_LT(apart.angle_deg, 1e-3) << i;
  }
  EXPECT_GT(
      Difference(all[0].front().world_from_camera, all[0].back().world_from_camera).distance_m,
      0.01);
}

}  // namespace
}  // namespace silt::experiments
