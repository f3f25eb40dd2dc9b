// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "silt/experiments/json.h"
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
  EXPECT_NE(result.error.find("--backend cuda"), std::string::npos);
  EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
}

TEST(BackendCommands, AutoSaysWhatItTook) {
  const ProgramResult result = RunSilt(kBatch + "--backend auto");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const bool gpu = HasCuda() && HasDevice();
  EXPECT_NE(result.error.find(gpu ? "--backend auto: cuda" : "--backend auto: cpu"),
            std::string::npos)
      << result.error;
}

TEST(BackendCommands, BatchesAreMeasuredOnEveryBackend) {
  for (const std::string backend : {"cpu", "cuda-emulated"}) {
    if (backend != "cpu" && !HasCuda()) continue;
    const ProgramResult result = RunSilt(kBatch + "--json - --backend " + backend);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["batch"]["alignments"], 3);
    EXPECT_GT(json["batch"]["per_s"], 0);
    EXPECT_GT(json["batch"]["floor_operations"], json["batch"]["floor_bytes"]);
    EXPECT_EQ(json["batch"]["device_ms"].is_null(), backend == "cpu");
  }
}

}  // namespace
}  // namespace silt::experiments
